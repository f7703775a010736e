// What carries a mechanism: rails and clamps in place, and posts from there down to the floor.

import { BoxGeometry, CylinderGeometry, Quaternion, SphereGeometry, Vector3 } from "three";
import { material, shaded } from "./geometry.js";

const Y = new Vector3(0, 1, 0);
// of a post and its foot, in radii of the links
const POST = 0.85, FOOT = 2.4, BEHIND = 3.6;

function rod(a, b, radius, paint) {
  const along = new Vector3().subVectors(b, a), length = along.length();
  const mesh = shaded(new CylinderGeometry(radius, radius, length, 36), paint);
  mesh.position.addVectors(a, b).multiplyScalar(0.5);
  if (length > 0) mesh.quaternion.setFromUnitVectors(Y, along.divideScalar(length));
  return mesh;
}

function knob(at, radius, paint) {
  const mesh = shaded(new SphereGeometry(radius, 28, 20), paint);
  mesh.position.copy(at);
  return mesh;
}

const place = (s) => [new Vector3(...s.at), new Vector3(...s.axis)];

function rail(s) {
  const [at, axis] = place(s);
  return s.travel.map((x, k) => at.clone().addScaledVector(axis, x + (k ? 5 : -5) * s.r));
}

// what stands where the ground holds something, with or without a floor
export const holders = {
  rail: (s, color) => rod(...rail(s), 0.7 * s.r, material(color)),
  clamp: (s, color) => {
    const [at, axis] = place(s), wall = shaded(new BoxGeometry(7 * s.r, 2.4 * s.r, 7 * s.r), material(color));
    wall.position.copy(at).addScaledVector(axis, -1.2 * s.r);
    wall.quaternion.setFromUnitVectors(Y, axis);
    return wall;
  },
};

// a post with a foot, straight down from a point to the floor
function post(from, s, stage, paint) {
  const foot = from.clone().addScaledVector(stage.up, stage.height - from.dot(stage.up));
  if (from.dot(stage.up) - stage.height < s.r) return [];
  const plate = foot.clone().addScaledVector(stage.up, 0.5 * s.r);
  return [rod(from, foot, POST * s.r, paint), rod(foot, plate, FOOT * s.r, paint)];
}

export function posts(s, stage, color) {
  const paint = material(color), [at, axis] = place(s), upright = axis.dot(stage.up);
  if (s.kind === "clamp") return [];
  if (Math.abs(upright) > 0.8) {
    // a mast in line with what turns or slides
    const low = s.kind === "rail" ? rail(s).sort((a, b) => a.dot(stage.up) - b.dot(stage.up))[0] : at;
    return post(low, s, stage, paint);
  }
  if (s.kind === "rail") return rail(s).flatMap((end) => [knob(end, POST * s.r, paint), ...post(end, s, stage, paint)]);
  // behind what turns, out of its way
  const back = at.clone().addScaledVector(axis, -Math.sign(axis.dot(stage.side()) || 1) * BEHIND * s.r);
  return [rod(at, back, 0.6 * s.r, paint), knob(back, POST * s.r, paint), ...post(back, s, stage, paint)];
}
