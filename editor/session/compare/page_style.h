// What the pages that the program writes have in common to look like; each adds what it alone needs. The pages open
// without a network.
#pragma once

namespace relievo {

inline constexpr const char* kPageStyle = R"(<style>
:root{color-scheme:light}
*{box-sizing:border-box}
body{margin:0;font:15px/1.5 system-ui,Segoe UI,Helvetica,Arial,sans-serif;color:#1d2026;background:#f4f5f7}
header,main{max-width:1600px;margin:0 auto;padding:0 28px}
header{padding-top:36px}
h1{font-size:30px;line-height:1.2;margin:0 0 6px}
h2{font-size:21px;margin:0 0 6px}
h3{font-size:15px;margin:20px 0 6px}
p{margin:6px 0;max-width:95ch}
a{color:#0057a8;text-decoration:none}
a:hover{text-decoration:underline}
.sub{color:#636973}
section{background:#fff;border:1px solid #dfe2e8;border-radius:10px;padding:22px 26px;margin:20px 0}
table{border-collapse:collapse;font-size:12.5px;font-variant-numeric:tabular-nums}
th,td{padding:4px 8px;text-align:right;white-space:nowrap}
td{border-bottom:1px solid #f0f1f4}
th{font-weight:600;color:#4a4f57;background:#f7f8fa;border-bottom:1px solid #dfe2e8;vertical-align:bottom}
.key span{padding:1px 9px;border-radius:4px;margin-right:6px}
footer{max-width:1600px;margin:0 auto;padding:0 28px 40px;color:#7a808a;font-size:13px}
</style>
)";

}  // namespace relievo
