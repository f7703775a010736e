(async () => {
  const raw = Uint8Array.from(atob(document.getElementById("program").textContent.trim()), (c) => c.charCodeAt(0));
  const script = document.createElement("script");
  script.type = "module";
  script.textContent = await new Response(new Blob([raw]).stream().pipeThrough(new DecompressionStream("deflate"))).text();
  document.body.append(script);
})();
