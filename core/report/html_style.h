// The look of the report page. For the sources of this folder only.
#pragma once

#include <string_view>

namespace gripscan {

inline constexpr std::string_view kHtmlStyle = R"css(
:root{--text:#16191d;--second:#46505a;--third:#56616c;--panel:#f7f8f9;--line:#d3d9df;
--accept:#0b7a55;--accept-bg:#ddf1e8;--check:#8a5a00;--check-bg:#faedd0;--reject:#bf3420;
--reject-bg:#fbe3de;--accent:#1f5fd6;--band:#1f5fd6}
*{box-sizing:border-box}
body{margin:0;background:#fff;color:var(--text);
font:15px/1.5 system-ui,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif}
main{max-width:1300px;margin:0 auto;padding:36px 28px 48px}
header{display:flex;justify-content:space-between;align-items:flex-end;gap:24px;flex-wrap:wrap;
border-bottom:1px solid var(--line);padding-bottom:18px}
h1{font-size:25px;font-weight:650;letter-spacing:-.01em;margin:0;overflow-wrap:anywhere}
h2{font-size:16px;font-weight:650;margin:36px 0 10px}
.kicker{color:var(--third);font-size:13px;margin:0}
.verdict{border-radius:8px;padding:9px 15px;font-weight:600}
.verdict.accept{color:var(--accept);background:var(--accept-bg)}
.verdict.check{color:var(--check);background:var(--check-bg)}
.verdict.reject{color:var(--reject);background:var(--reject-bg)}
dl.figures{display:grid;grid-template-columns:repeat(auto-fit,minmax(245px,1fr));gap:12px;
margin:22px 0 0}
dl.figures div{background:var(--panel);border:1px solid var(--line);border-radius:8px;
padding:10px 14px}
dt{color:var(--third);font-size:12.5px}
dd{margin:1px 0 0;font-size:18px;font-weight:600;font-variant-numeric:tabular-nums}
dd small{font-size:13px;font-weight:400;color:var(--second)}
svg{width:100%;height:auto;display:block}
svg .grid{stroke:var(--line);stroke-width:1}
svg .zero{stroke:var(--third);stroke-width:1}
svg .limit{stroke:var(--check);stroke-width:1.4;stroke-dasharray:7 5}
svg .band{fill:var(--band);fill-opacity:.20}
svg .band-wide{fill:var(--band);fill-opacity:.08}
svg .tick{fill:var(--third);font-size:12px}
svg .value{fill:var(--reject);font-size:12px;font-weight:600}
svg .mark.accept,svg .mark.accept_noted{fill:var(--accept);stroke:#fff;stroke-width:1.2}
svg .mark.check{fill:var(--check);stroke:#fff;stroke-width:1.2}
svg path.mark.reject{fill:none;stroke:var(--reject);stroke-width:2.6;stroke-linecap:round}
svg text.mark.reject{fill:var(--reject);font-size:15px;font-weight:700}
.legend{color:var(--second);font-size:13px;margin:6px 0 0}
.scroll{overflow-x:auto}
.scroll svg{min-width:760px}
table{border-collapse:collapse;width:100%;font-size:12px;font-variant-numeric:tabular-nums}
th{font-weight:600;color:var(--third);text-align:right;vertical-align:top;
border-bottom:1.5px solid var(--third);padding:4px 5px}
th small{font-weight:400}
td{text-align:right;padding:3px 5px;border-bottom:1px solid #eceff2;white-space:nowrap}
th:nth-last-child(-n+2),td:nth-last-child(-n+2){text-align:left}
tr.check td{background:var(--check-bg)}
tr.reject td{background:var(--reject-bg)}
tr.sum td{font-weight:650;border-top:1.5px solid var(--third);border-bottom:0}
ul.causes{padding-left:20px;margin:0}
ul.causes li{margin:4px 0}
b.accept,b.accept_noted{color:var(--accept)}
b.check{color:var(--check)}
b.reject{color:var(--reject)}
p.note{color:var(--second);font-size:13px;max-width:78ch;margin:8px 0 0}
footer{color:var(--third);font-size:12.5px;border-top:1px solid var(--line);margin-top:36px;
padding-top:12px}
@media print{
@page{size:A4 landscape;margin:12mm}
body{font-size:11px;-webkit-print-color-adjust:exact;print-color-adjust:exact}
main{max-width:none;padding:0}
table{font-size:9px;line-height:1.3}td,th{padding:1.5px 4px}
h1{font-size:20px}
dd{font-size:15px}
dd small,dt,.kicker,.legend,p.note,footer{font-size:10.5px}
h2{margin:18px 0 6px;break-after:avoid}
section,li,p.note,tr,svg,dl.figures div{break-inside:avoid}
ul.causes li{margin:2px 0}
p.note{max-width:120ch}
footer{margin-top:18px}
.scroll{overflow:visible}}
)css";

}  // namespace gripscan
