#include "reports/html_parts.h"

namespace zproof {

namespace {

constexpr std::string_view style = R"css(
:root {
  color-scheme: light dark;
  --ground: #fcfcfa; --ink: #1c2026; --quiet: #5d6670; --line: #e2e2dc; --soft: #f3f3ef;
  --blue: #0072b2; --proven: #00704f; --defect: #b04400; --doubt: #8a5a00; --link: #005b92;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ground: #14161a; --ink: #e3e6ea; --quiet: #98a1ab; --line: #2c3138; --soft: #1c1f25;
    --blue: #56b4e9; --proven: #3cc79c; --defect: #ff8a3d; --doubt: #f0c04a; --link: #7cc4ee;
  }
}
* { box-sizing: border-box; }
html { scroll-behavior: auto; -webkit-text-size-adjust: 100%; }
body {
  margin: 0 auto; max-width: 1240px; padding: 2.5rem 2rem 5rem; background: var(--ground); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif;
  font-variant-numeric: tabular-nums;
}
h1 { font-size: 1.75rem; font-weight: 600; letter-spacing: -0.01em; line-height: 1.2; margin: 0 0 0.6rem; }
h2 { font-size: 1.2rem; font-weight: 600; margin: 0 0 0.4rem; overflow-wrap: anywhere; }
h3 { font-size: 0.8rem; font-weight: 600; color: var(--quiet); margin: 0 0 0.5rem; }
p { margin: 0 0 0.6rem; }
a { color: var(--link); text-decoration-thickness: 1px; text-underline-offset: 2px; }
code { font: 0.86em/1.5 ui-monospace, "SF Mono", "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; }
section { border-top: 1px solid var(--line); margin-top: 2.5rem; padding-top: 1.5rem; }
.facts, .fine { color: var(--quiet); font-size: 0.86rem; margin-bottom: 0.3rem; overflow-wrap: anywhere; }
.reason { max-width: 48rem; }
.message { color: var(--defect); }
.view { color: var(--quiet); font-weight: 400; }
.cause { font-size: 1.1rem; max-width: 52rem; }
.cards {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); gap: 1rem; margin: 0 0 1.6rem;
}
.cards[hidden] { display: none; }
.card {
  display: flex; flex-direction: column; color: inherit; text-decoration: none; min-width: 0;
  overflow-wrap: anywhere; border-radius: 4px;
}
.card:hover .name { text-decoration: underline; }
.card img {
  display: block; width: 100%; aspect-ratio: 16 / 9;
  object-fit: contain; background: #000; border-radius: 3px;
  margin-bottom: 0.35rem;
}
.card:has(.outcome:not(.proven)) img { box-shadow: 0 0 0 2px var(--defect); }
.card .name { font-weight: 600; line-height: 1.3; }
.card .outcome { font-size: 0.86rem; }
.card .fine { margin: 0; line-height: 1.35; }
.rings { margin: 1.4rem 0 0.8rem; }
.rings .class { margin-left: 0.5rem; }
details > summary { cursor: pointer; }
details > summary > h2 { display: inline; }
#sections section:has(> details:not([open])) { margin-top: 0; padding: 0.45rem 0; }
#sections section:has(> details:not([open])) h2 { font-size: 1rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; }
th {
  font-size: 0.8rem; font-weight: 500; color: var(--quiet); text-align: left; vertical-align: bottom;
  line-height: 1.25;
}
th, td { padding: 0.32rem 0.8rem 0.32rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th:last-child, td:last-child { padding-right: 0; }
.n { text-align: right; white-space: nowrap; }
.zero { color: var(--quiet); opacity: 0.6; }
.summary { width: 100%; margin-top: 1.6rem; }
.summary td:nth-child(2) { min-width: 11rem; overflow-wrap: anywhere; }
.summary a { text-decoration: none; }
.summary a:hover { text-decoration: underline; }
.defects:not(.zero) { color: var(--defect); font-weight: 600; }
.outcome { white-space: nowrap; font-weight: 600; }
h2 .outcome { font-size: 0.86rem; margin-left: 0.6rem; }
.proven { color: var(--proven); }
.defective { color: var(--defect); }
.undecided, .unreadable, .not_judged, .internal_error { color: var(--doubt); }
.class { display: inline-flex; align-items: center; gap: 0.5rem; white-space: nowrap; }
.class i {
  display: inline-block; width: 1.3em; height: 1.3em; border-radius: 3px; text-align: center;
  font-style: normal; font-size: 0.82em; font-weight: 600; line-height: 1.3em;
  box-shadow: inset 0 0 0 1px rgb(128 128 128 / 45%);
  print-color-adjust: exact; -webkit-print-color-adjust: exact;
}
.legend p { max-width: 52rem; }
.columns {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(24rem, 1fr)); gap: 0.5rem 3rem;
  margin-top: 1rem;
}
dl {
  display: grid; grid-template-columns: max-content 1fr; gap: 0.35rem 1rem; margin: 0 0 0.8rem;
  font-size: 0.92rem;
}
dd { margin: 0; }
.notes { color: var(--quiet); font-size: 0.86rem; margin: 0 0 0.6rem; padding-left: 1.1rem; }
.figures {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(250px, 1fr)); gap: 1rem;
  margin: 1.1rem 0 1.4rem;
}
figure { margin: 0; }
figure img { display: block; width: 100%; border-radius: 3px; background: #14161a; }
figure img.sharp { image-rendering: pixelated; }
figcaption { color: var(--quiet); font-size: 0.8rem; margin-top: 0.35rem; line-height: 1.35; }
.absent {
  background: var(--soft); color: var(--quiet); font-size: 0.86rem; padding: 2rem 1rem; margin: 0;
  text-align: center;
}
.map {
  display: grid; grid-template-columns: minmax(0, 8fr) minmax(17rem, 5fr); gap: 1.2rem 2.2rem;
  margin-top: 1.1rem;
}
.map > :only-child { grid-column: 1 / -1; }
.panels {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(270px, 1fr)); gap: 1.2rem 2.5rem;
  margin-bottom: 1.2rem;
}
.counts { width: 100%; margin-bottom: 0.5rem; font-size: 0.92rem; }
.counts .gate { color: var(--quiet); width: 4rem; }
.counts .gate strong { color: var(--defect); }
svg { display: block; width: 100%; max-width: 460px; margin-bottom: 0.3rem; }
svg text { font-size: 9px; fill: var(--quiet); }
svg .x { text-anchor: middle; }
svg .y { text-anchor: end; }
svg .grid { stroke: var(--line); stroke-width: 1; }
svg .axis { stroke: var(--quiet); stroke-width: 1; }
svg .bound { stroke: var(--defect); stroke-width: 1.5; stroke-dasharray: 3 2; }
svg .bar { fill: var(--blue); }
svg .over { fill: var(--defect); }
.worst { width: 100%; font-size: 0.92rem; }
.worst .words { min-width: 22rem; }
.worst code { color: var(--quiet); user-select: all; }
.stages { margin-top: 0.9rem; }
.stages span { display: inline-block; margin-right: 1.2rem; }
@media (max-width: 700px) {
  body { padding: 1.2rem 1rem 3rem; }
  .columns, .map { grid-template-columns: 1fr; }
  .cards { grid-template-columns: repeat(auto-fill, minmax(9rem, 1fr)); gap: 0.7rem; }
}
@media print {
  :root {
    --ground: #fff; --ink: #000; --quiet: #444; --line: #ccc; --soft: #f4f4f4;
    --blue: #0072b2; --proven: #00573e; --defect: #9a3b00; --doubt: #6d4700; --link: #000;
  }
  body { max-width: none; padding: 0; font-size: 10pt; }
  section { break-before: auto; }
  .map, .figures, .panels, tr, h2, h3 { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  .figures { grid-template-columns: repeat(3, 1fr); }
  .wide { overflow: visible; }
  .summary { font-size: 7.5pt; }
  img, svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

}  // namespace

std::string_view html_style() { return style; }

}  // namespace zproof
