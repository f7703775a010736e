// Bundles the page with three into ../page.min.js, which begins with the hash of its sources.

import { createHash } from "node:crypto";
import { copyFileSync, readdirSync, readFileSync } from "node:fs";
import { build } from "esbuild";

const sources = readdirSync(".").filter((name) => name.endsWith(".js") || name === "package.json").sort();
const hash = createHash("sha256");
for (const name of sources) hash.update(readFileSync(name));
await build({
  entryPoints: ["main.js"], bundle: true, minify: true, format: "esm", target: "es2022", legalComments: "none",
  outfile: "../page.min.js", banner: { js: `// three.js (MIT, three.LICENSE) and sources ${hash.digest("hex")}` },
});
copyFileSync("node_modules/three/LICENSE", "../three.LICENSE");
