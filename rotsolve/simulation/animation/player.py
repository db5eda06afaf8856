"""Player: how the page of a motion looks, and the script that moves it."""

STYLE = (
    "body{margin:0;background:var(--paper);color:var(--ink)}"
    "main{max-width:56rem;margin:0 auto;padding:1rem}"
    "h1{font-size:1.3rem;font-weight:600;margin:0 0 .6rem}h2{font-size:1rem;margin:1rem 0 .3rem}"
    "#picture{display:block;max-width:100%;height:auto;max-height:62vh;margin:0 auto}"
    ".head{fill:var(--ink)}.to-force.head{fill:var(--force)}.to-spin.head{fill:var(--spin)}.to-sense.head{fill:var(--sense)}"
    ".to-faint.head{fill:var(--faint)}"
    ".label text{paint-order:stroke;stroke:var(--paper)!important;stroke-width:2.5px;stroke-linejoin:round}"
    ".controls{display:flex;flex-wrap:wrap;gap:.8rem;align-items:center;margin-top:.8rem}"
    "button,select,output{font:inherit;color:inherit}"
    "button,select{background:var(--body);border:1px solid var(--faint);border-radius:4px;padding:.15rem .6rem}"
    "#play{width:3.6rem}"
    ".track{position:relative;flex:1 1 14rem;height:2rem}"
    ".track input{width:100%;margin:0;height:1.3rem;accent-color:var(--spin)}"
    ".tick{position:absolute;top:1.3rem;left:calc(8px + (100% - 16px) * var(--at) / 100);width:2px;height:.6rem;margin-left:-1px;"
    "background:var(--force)}"
    "#clock{min-width:8.5rem;font-variant-numeric:tabular-nums}"
    ".note{color:var(--faint);font-size:.85rem;margin:.4rem 0}"
    ".event{color:var(--force);min-height:1.3em;margin:.2rem 0}"
    "table{border-collapse:collapse;font-size:.9rem;margin-top:.4rem}caption{text-align:left;color:var(--faint);padding:.2rem 0}"
    "th{text-align:left;font-weight:normal;padding:.1rem 1.2rem .1rem 0}thead th{color:var(--faint)}"
    "td{text-align:right;padding:.1rem .6rem;font-variant-numeric:tabular-nums}td+td{text-align:left;color:var(--faint)}"
    "small{color:var(--faint)}.events{list-style:none;padding:0;margin:0}.events li{margin:.2rem 0}"
)

SCRIPT = """
"use strict";
(() => {
  const motion = JSON.parse(document.getElementById("motion").textContent);
  const find = name => document.getElementById(name);
  const last = motion.times.length - 1, step = motion.step;
  const paths = [...document.querySelectorAll("#picture path")];
  const labels = [...document.querySelectorAll("#picture .label")];
  const cells = [...document.querySelectorAll("#numbers tbody tr")].map(row => row.cells[1]);
  const at = (told, moment) => typeof told === "number" ? told : told[moment];
  const still = told => typeof told === "number";
  const lines = motion.lines.map((line, number) => [line, paths[number]])
    .filter(([line]) => ![line.r, line.s, line.x, line.y].every(still));
  let moment = -1, playing = false, clock = 0, before = null;

  function show(number) {
    number = Math.max(0, Math.min(last, number));
    if (number === moment) return;
    moment = number;
    for (const [line, path] of lines) {
      path.setAttribute("d", `M${at(line.x, moment) / 10} ${at(line.y, moment) / 10}${motion.shapes[at(line.s, moment)]}`);
      if (!still(line.r)) path.setAttribute("class", motion.roles[at(line.r, moment)]);
    }
    motion.labels.forEach((label, number) => {
      const x = at(label.x, moment) / 10, y = at(label.y, moment) / 10;
      labels[number].setAttribute("transform", `translate(${x} ${y})`);
    });
    motion.values.forEach((column, number) => { cells[number].textContent = column[moment]; });
    find("time").value = moment;
    const time = `t = ${motion.times[moment]} s`;
    find("clock").textContent = time;
    find("time").setAttribute("aria-valuetext", time);
    const now = moment === last ? motion.end : moment * step;
    const passed = motion.events.filter(event => event.at <= now * (1 + 1e-9));
    const event = passed[passed.length - 1];
    find("event").textContent = event ? `t = ${Number(event.at.toPrecision(6))} s: ${event.what}` : "";
  }

  function go(time) {
    clock = Math.max(0, Math.min(motion.end, time));
    show(clock < motion.end ? Math.floor(clock / step + 1e-6) : last);
  }

  function play(on) {
    playing = on;
    before = null;
    if (on && clock >= motion.end) clock = 0;
    find("play").textContent = on ? "❚❚" : "▶";
    find("play").setAttribute("aria-label", on ? "Pause" : "Play");
    if (on) requestAnimationFrame(tick);
  }

  function tick(now) {
    if (!playing) return;
    if (before !== null) go(clock + (now - before) / 1000 * Number(find("speed").value));
    before = now;
    if (clock >= motion.end) play(false);
    else requestAnimationFrame(tick);
  }

  function started() {
    const told = /t=([0-9.eE+-]+)/.exec(location.hash);
    if (!told || !isFinite(Number(told[1]))) return false;
    play(false);
    go(Number(told[1]));
    return true;
  }

  find("play").addEventListener("click", () => play(!playing));
  find("time").addEventListener("input", () => { play(false); go(Number(find("time").value) * step); });
  document.querySelectorAll("[data-at]").forEach(button =>
    button.addEventListener("click", () => { play(false); go(Number(button.dataset.at)); }));
  addEventListener("hashchange", started);
  show(0);
  if (!started() && !matchMedia("(prefers-reduced-motion: reduce)").matches) play(true);
})();
"""
