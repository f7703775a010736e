"""Style of pages: the measure, the type and the tables of a book, for light and dark screens."""

from __future__ import annotations

STYLE = """
:root { --ink: #1d1b18; --soft: #6a645a; --line: #c9c2b4; --paper: #fffdf8; --mark: #7a2f1d;
        color-scheme: light dark; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4dfd5; --soft: #a39c8e; --line: #4a463f; --paper: #191816; --mark: #e0a08c; }
  figure svg { background: #f3efe6; border-radius: .4rem; padding: .5rem; }
}
* { box-sizing: border-box; }
html { background: var(--paper); }
body { font: 1.0625rem/1.55 "Latin Modern Roman", "STIX Two Text", Palatino, "Palatino Linotype",
       Georgia, "DejaVu Serif", serif; color: var(--ink); max-width: 46rem; margin: 0 auto;
       padding: 3.5rem 1.4rem 5rem; overflow-wrap: anywhere; hyphens: auto;
       font-variant-numeric: oldstyle-nums; }
header { border-bottom: 1px solid var(--line); padding-bottom: 1.2rem; }
h1 { font-size: 2.1rem; font-weight: 500; line-height: 1.15; margin: 0 0 .6rem; }
h2 { font-size: 1.3rem; font-weight: 500; line-height: 1.25; margin: 2.8rem 0 .8rem; }
h2 span { color: var(--mark); margin-right: .5rem; }
p { margin: .55rem 0; } .quiet, figcaption, summary { color: var(--soft); font-size: .93rem; }
ul { margin: .5rem 0; padding-left: 1.2rem; } li { margin: .3rem 0; }
figure { margin: 1.2rem 0; text-align: center; } figure svg { max-width: 100%; height: auto; }
figcaption { margin-top: .4rem; }
math { overflow-wrap: normal; white-space: nowrap; font-size: 1.03em;
       font-family: "Latin Modern Math", "STIX Two Math", "Cambria Math", "Libertinus Math",
       "TeX Gyre Termes Math", math, serif; }
/* dots above words are seen as well as those above letters */
mover > mo { font-size: 145%; }
.formula { margin: 1.1rem 0 .25rem; padding-left: 3.2rem; text-indent: -2rem; line-height: 1.9; }
.terms { margin: 0 0 1.1rem 1.2rem; padding-left: .9rem; border-left: 1px solid var(--line);
         display: grid; grid-template-columns: minmax(5rem, 11rem) minmax(0, 1fr);
         gap: .3rem 1rem; align-items: baseline; font-size: .94rem;
         line-height: 1.75; }
dt, .origin { color: var(--soft); font-style: italic; }
.origin { margin-left: 1.5rem; font-size: .88rem; display: inline-block; text-indent: 0; }
dt { line-height: 1.35; padding-top: .25rem; }
dd { margin: 0; min-width: 0; padding-left: 1.2rem; text-indent: -1.2rem; }
table { width: 100%; border-collapse: collapse; margin: .9rem 0 1.4rem; font-size: .93rem;
        line-height: 1.4; border-top: 1.5px solid var(--ink); border-bottom: 1.5px solid var(--ink);
        font-variant-numeric: lining-nums tabular-nums; }
th { font-weight: 500; font-style: italic; text-align: left; border-bottom: 1px solid var(--ink);
     overflow-wrap: break-word; }
th, td { padding: .22rem .7rem .22rem 0; vertical-align: baseline; }
th:last-child, td:last-child { padding-right: 0; }
sup { font-size: .72em; line-height: 0; }
.number { text-align: right; white-space: nowrap; }
th.number { white-space: normal; }
details { margin: .8rem 0; } summary { cursor: pointer; }
details .formula { margin: .3rem 0; line-height: 1.6; font-size: .93rem; }
@media (max-width: 34rem) {
  body { font-size: 1rem; padding: 1.6rem 1rem 3rem; } h1 { font-size: 1.6rem; }
  .formula { padding-left: 1.6rem; text-indent: -1.2rem; }
  .terms { grid-template-columns: minmax(0, 1fr); margin-left: .3rem; }
  .wide { display: none; } th, td { padding-right: .45rem; } table { font-size: .86rem; }
}
@media print { body { max-width: none; padding: 0; font-size: 10.5pt; } h2 { break-after: avoid; }
  tr, .formula { break-inside: avoid; } details:not([open]) { display: none; } }
"""
