#pragma once
// How a page looks: light or dark as the reader's system is, and light in print.

namespace tektite {

inline constexpr const char* page_style =
    R"(:root { --ink: #1b1f24; --ground: #ffffff; --faint: #d5d9de; --soft: #f4f5f7; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e8eb; --ground: #15181c; --faint: #3c434b; --soft: #20252b; }
}
@media print {
  :root { --ink: #000000; --ground: #ffffff; --faint: #bbbbbb; --soft: #ffffff; }
  h2 { break-after: avoid; }
  figure, tr { break-inside: avoid; }
  body { max-width: none; margin: 0; font-size: 10pt; }
}
body { margin: 2rem auto; max-width: 78rem; padding: 0 1rem; background: var(--ground); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { line-height: 1.2; }
h2 { margin-top: 2.5rem; border-bottom: 1px solid var(--faint); }
table { border-collapse: collapse; display: block; overflow-x: auto; font-variant-numeric: tabular-nums; }
th, td { padding: 0.25rem 0.75rem; border-bottom: 1px solid var(--faint); text-align: left; vertical-align: top; }
tr:first-child th { background: var(--soft); }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1rem; margin: 1rem 0; }
figure { margin: 0; }
figcaption { font-size: 0.85rem; overflow-wrap: anywhere; }
img { width: 100%; background: #ffffff; border-radius: 4px; }
svg { width: 100%; max-width: 48rem; }
svg text { fill: var(--ink); font: 14px system-ui, sans-serif; }
.axis { fill: none; stroke: var(--ink); }
.zero { stroke: var(--faint); }
.curve { fill: none; stroke-width: 2; }
pre { background: var(--soft); padding: 1rem; white-space: pre-wrap; overflow-wrap: anywhere; font-size: 0.85rem; }
)";

}  // namespace tektite
