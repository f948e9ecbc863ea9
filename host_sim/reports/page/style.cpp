// The look of the pages: one column on a telephone, rows of pictures on a desk, light and dark as the reader's system
// is.
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

const char* page_style() {
  return R"css(
:root{color-scheme:light dark;--paper:#fbfbfa;--card:#fff;--ink:#1d2126;--soft:#57606a;--edge:#e1e4e8;--grid:#eaedf0;--frame:#aab2bb;
--good:#2c7a3f;--bad:#b3261e;--warn:#9a6700;--measured:#24292f;--given:#cf5a0c;--extended:#1466c4;--truth:#2c7a3f;--term1:#0b7f8a;
--term2:#7d4fa6;--term3:#a87b00;--term4:#b93a72;--term5:#75563b;--term6:#5f7d1a;--term7:#53687c;--term8:#a3485a;--cut:#0000002e}
@media (prefers-color-scheme:dark){:root{--paper:#14171a;--card:#1b1f24;--ink:#e8eaed;--soft:#a3acb6;--edge:#2f353c;--grid:#2a3037;
--frame:#59636e;--good:#6fc684;--bad:#ff8a80;--warn:#e3b341;--measured:#dfe3e7;--given:#ff9a4d;--extended:#62aeff;--truth:#6fc684;
--term1:#4fc3cf;--term2:#c39be8;--term3:#e0b84a;--term4:#f080ae;--term5:#c9a27e;--term6:#b5d15c;--term7:#a9bccf;--term8:#f0a0a8;--cut:#ffffff38}}
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif}
main{max-width:1180px;margin:0 auto;padding:40px 24px 80px}
.kicker{margin:0;color:var(--soft);font-size:13px;letter-spacing:.08em;text-transform:uppercase}
h1{font-size:clamp(23px,3.2vw,32px);line-height:1.2;margin:6px 0 14px;letter-spacing:-.015em;font-weight:650;text-wrap:balance}
h2{font-size:22px;line-height:1.3;margin:56px 0 6px;letter-spacing:-.01em;font-weight:640}
h3{font-size:16px;margin:26px 0 8px;font-weight:640}
p{max-width:74ch;margin:8px 0}
.lead{font-size:17px}
details{margin:10px 0}summary{cursor:pointer;font-size:14px;color:var(--soft)}.sentence{display:inline-block;min-width:240px;max-width:68ch;white-space:normal}
.why,.facts{color:var(--soft)}
.facts{font-size:14px;margin:0;padding:0;list-style:none;display:flex;flex-wrap:wrap;gap:2px 18px}
.facts li{overflow-wrap:anywhere}
.badge{display:inline-block;padding:3px 12px;border-radius:99px;font-size:13px;font-weight:650;letter-spacing:.03em;border:1px solid currentColor}
.good{color:var(--good)}.bad{color:var(--bad)}.warn{color:var(--warn)}
nav{display:flex;flex-wrap:wrap;gap:4px 20px;margin:22px 0 0;padding:12px 0;border-block:1px solid var(--edge);font-size:14px}
a{color:var(--extended);text-decoration:none}a:hover{text-decoration:underline}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,270px),1fr));gap:16px;margin:18px 0 0}
.card,figure{background:var(--card);border:1px solid var(--edge);border-radius:10px}
.card{padding:16px 18px}.card p{margin:4px 0;font-size:14px}.card b{font-size:17px;font-weight:650;overflow-wrap:anywhere}
.card .big{font-size:28px;font-weight:650;letter-spacing:-.02em;line-height:1.25}
.row{display:grid;gap:16px;margin:0 0 16px;grid-template-columns:minmax(0,1fr)}
figure{margin:0;padding:12px 12px 8px;min-width:0}
figcaption{font-size:14px;font-weight:600;padding:0 4px 2px}
figure p{font-size:13px;color:var(--soft);margin:2px 4px 4px}
svg{display:block;width:100%;height:auto;font-family:inherit}
svg g,svg text{font-size:12.5px}
.p{fill:none;stroke:currentColor;stroke-width:1;stroke-linecap:round;stroke-linejoin:round}
.gridline{stroke:var(--grid);stroke-linecap:butt}.t{stroke:none;fill:var(--soft)}
@media (min-width:760px){.row2{grid-template-columns:repeat(2,minmax(0,1fr))}.row3{grid-template-columns:repeat(2,minmax(0,1fr))}.row1{max-width:760px}}
@media (min-width:1100px){.row3{grid-template-columns:repeat(3,minmax(0,1fr))}.row2 svg g,.row2 svg text{font-size:11px}.row3 svg g,.row3 svg text{font-size:14px}}
.legend{list-style:none;display:flex;flex-wrap:wrap;gap:2px 20px;padding:0;margin:12px 0 8px;font-size:14px}
.legend i{display:inline-block;width:24px;margin-right:7px;vertical-align:middle;height:0;border-top:3px solid var(--c)}
.legend i.dashed{border-top-style:dashed}.legend i.band{height:12px;border:0;background:var(--c);opacity:.3;border-radius:2px}
.scroll{overflow-x:auto;margin:12px 0;border:1px solid var(--edge);border-radius:10px;background:linear-gradient(90deg,var(--card) 30%,transparent) 0 0/60px 100% no-repeat local,
linear-gradient(270deg,var(--card) 30%,transparent) 100% 0/60px 100% no-repeat local,linear-gradient(90deg,var(--cut),transparent) 0 0/16px 100% no-repeat scroll,
linear-gradient(270deg,var(--cut),transparent) 100% 0/16px 100% no-repeat scroll var(--card)}
table{border-collapse:collapse;width:100%;font-size:14px;line-height:1.4}
th,td{padding:8px 14px;text-align:left;white-space:nowrap;border-bottom:1px solid var(--edge);vertical-align:middle}
tbody tr:last-child td{border-bottom:0}
th{font-weight:600;color:var(--soft);font-size:13px}
.n{text-align:right;font-variant-numeric:tabular-nums}
td.wide{white-space:normal;min-width:220px}
.chosen{font-weight:650}.dim{color:var(--soft)}
.bar{display:inline-block;width:120px;height:9px;border-radius:5px;background:var(--grid);vertical-align:middle;overflow:hidden}
.bar span{display:block;height:100%;border-radius:5px}
code{font-family:ui-monospace,"SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace;font-size:.93em}
sup{line-height:0;font-size:.75em}
.advice li{margin:6px 0;max-width:74ch}
.zoom{margin:8px 0}.zoom p{min-height:1.5em;display:flex;flex-wrap:wrap;gap:2px 18px}.zoom i{display:inline-block;width:22px;border-top:3px solid;vertical-align:middle;margin-right:6px}.choose label{color:var(--soft)}select{font:inherit;max-width:100%;color:var(--ink);background:var(--card);border:1px solid var(--edge);border-radius:6px;padding:4px 8px}
.zoom .dygraph-axis-label{color:var(--soft);font-size:12px}.zoom .dygraph-label{color:var(--soft);font-size:12px;font-weight:400}#zoom-signals,#zoom-errors{width:100%;margin-bottom:8px}
@media (max-width:500px){th,td{padding:7px 9px;font-size:13px}.bar{width:56px}td .dim{display:block}svg g,svg text{font-size:14.5px}main{padding:24px 14px 56px}h2{margin-top:44px}}
@media print{body{background:#fff}main{padding:0;max-width:none}figure,.card,tr{break-inside:avoid}h2,h3,h2+p,h3+p,.legend,thead{break-after:avoid}nav{display:none}
.row2,.row3{grid-template-columns:repeat(2,minmax(0,1fr))}.scroll{overflow:visible;background:none}table{font-size:9.5pt}th,td{white-space:normal;padding:3px 6px;overflow-wrap:break-word}th{font-size:9pt}td.wide{min-width:0}.bar{width:40px}}
)css";
}

}  // namespace host_sim::reports
