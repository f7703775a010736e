// Text of the page that is deflated, and the script among it.
async function inflated(id) {
  const raw = Uint8Array.from(atob(document.getElementById(id).textContent.trim()), (c) => c.charCodeAt(0));
  return new Response(new Blob([raw]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}
const liveProgram = (async () => {
  const script = document.createElement("script");
  script.textContent = new TextDecoder().decode(await inflated("live-program"));
  document.body.append(script);
})();
async function startLive(data, viewer) {
  await liveProgram;
  await runLive(data, viewer);
}
