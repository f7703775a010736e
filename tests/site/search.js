// Sphinx's own search over a built site: node search.js SITE 'query' ... prints ranked pages as JSON.
const fs = require("fs"), path = require("path"), vm = require("vm");
const [site, ...queries] = process.argv.slice(2);
const element = { dataset: { content_root: "./" }, children: [], childNodes: [] };
const page = {
  document: {
    addEventListener() {},
    getElementById: () => null,
    documentElement: element,
    readyState: "loading",
  },
  localStorage: { setItem() {}, getItem: () => null, removeItem() {} },
  location: { search: "" },
  URLSearchParams,
  URL,
  console,
};
page.window = page;
const context = vm.createContext(page);
for (const name of ["documentation_options", "doctools", "sphinx_highlight", "language_data", "searchtools"])
  vm.runInContext(fs.readFileSync(path.join(site, "_static", `${name}.js`), "utf8"), context);
vm.runInContext("var _removeChildren_ = 0;", context);
vm.runInContext(fs.readFileSync(path.join(site, "searchindex.js"), "utf8"), context);
const ranked = (query) => {
  context.query = query;
  const found = vm.runInContext("Search._performSearch(...Search._parseQuery(query))", context);
  return found.reverse().map((one) => one[0] + one[2]);
};
console.log(JSON.stringify(queries.map(ranked)));
