#include "belief/view/run_page_parts.hpp"

#include "search/text/markup.hpp"

namespace praxis::belief {
namespace {

constexpr const char* kStyle = R"(
body{font:14px/1.45 system-ui,sans-serif;margin:1.5em;color:#1d2733;background:#fff}
h1{font-size:1.3em;margin:0 0 .2em}h2{font-size:1em;margin:1.1em 0 .3em}
p{margin:.2em 0}.quiet{color:#66737f}
code,td.atom,td.past{font:12px ui-monospace,monospace}
nav{display:flex;gap:.6em;align-items:center;position:sticky;top:0;background:inherit;padding:.6em 0}
nav input{flex:1}main{display:flex;gap:2.5em;flex-wrap:wrap}
section{min-width:20em}ol{margin:.2em 0;padding-left:2.4em}li.done{opacity:.45}
#steps{max-height:45vh;overflow:auto}#steps li{cursor:pointer;padding:0 .3em}
#steps li.now{background:#dcebfa}table{border-collapse:collapse}
td{padding:.1em .7em;border-bottom:1px solid #e4e9ee}tr.new{background:#fff2cc}
.t{color:#1c7a37}.f{color:#b3372b}.u{color:#8896a3}td.past{letter-spacing:.1em;white-space:nowrap}
.past .here{outline:2px solid #6b8db0}
@media(prefers-color-scheme:dark){body{background:#14191f;color:#d9e1e8}.quiet{color:#93a1ad}
td{border-color:#2a343f}tr.new{background:#4a3d12}#steps li.now{background:#1e3a56}
.t{color:#6fd08b}.f{color:#ef8a80}}
)";

constexpr const char* kBody = R"(
<nav><button id="back" aria-label="step back">&#9664;</button>
<input id="slider" type="range" min="0" value="0" aria-label="step">
<button id="on" aria-label="step on">&#9654;</button><span id="where"></span></nav>
<noscript><p>This page needs JavaScript to show the run.</p></noscript>
<main><section>
<h2>Action</h2><p><code id="action"></code></p><p id="failure" class="f"></p>
<h2>Read</h2><ul id="read"></ul>
<h2>Plan <span id="reason" class="quiet"></span></h2><ol id="plan"></ol>
<p id="end"></p>
<h2>Steps</h2><ol id="steps" start="0"></ol>
</section><section>
<h2>Known <span id="counts" class="quiet"></span></h2>
<p><label><input id="only" type="checkbox"> only what changes</label>
<input id="filter" placeholder="find" aria-label="find atoms"></p>
<table><tbody id="atoms"></tbody></table>
</section></main>
)";

constexpr const char* kScript = R"(
'use strict';
const run = JSON.parse(document.getElementById('run').textContent);
const get = id => document.getElementById(id);
const signs = ['?', '\u2713', '\u2717'], classes = ['u', 't', 'f'];
const words = ['unknown', 'true', 'false'];
const last = run.steps.length - 1;
// Beyond this many steps, the row of past and coming values would be too long.
const pastShown = run.steps.length <= 120;
const changing = new Set(run.steps.flatMap(s => s.changes.map(c => c[0])));
const history = pastShown ? run.atoms.map(a => [a.first]) : [];
if (pastShown) run.steps.forEach((step, i) => {
  if (i) history.forEach(h => h.push(h[i - 1]));
  step.changes.forEach(([atom, value]) => { history[atom][i] = value; });
});
function element(name, text, kind) {
  const e = document.createElement(name);
  if (text !== undefined) e.textContent = text;
  if (kind) e.className = kind;
  return e;
}
function fill(id, children) { get(id).replaceChildren(...children); }
function values(step) {
  const now = run.atoms.map(a => a.first);
  for (let i = 0; i <= step; ++i) run.steps[i].changes.forEach(([atom, value]) => { now[atom] = value; });
  return now;
}
function planAt(step) {
  for (let i = step; i >= 0; --i) {
    const plans = run.steps[i].plans;
    if (plans.length) return {plan: plans[plans.length - 1], since: i};
  }
  return null;
}
function showPlan(step) {
  const found = planAt(step);
  if (!found) { get('reason').textContent = ''; fill('plan', []); return; }
  get('reason').textContent = found.plan.actions.length + ' actions, made after step ' + found.since +
      (found.plan.reason ? ': ' + found.plan.reason : '');
  const done = found.plan.actions.map(() => false);
  for (let i = found.since + 1; i <= step; ++i) {
    const k = found.plan.actions.findIndex((a, j) => !done[j] && a === run.steps[i].action);
    if (k >= 0) done[k] = true;
  }
  fill('plan', found.plan.actions.map((a, i) => {
    const e = element('li', undefined, done[i] ? 'done' : '');
    e.append(element('code', a));
    return e;
  }));
}
function showAtoms(step) {
  const now = values(step), changed = new Set(run.steps[step].changes.map(c => c[0]));
  const only = get('only').checked, part = get('filter').value.toLowerCase();
  const count = [0, 0, 0];
  now.forEach(v => { ++count[v]; });
  get('counts').textContent = count[1] + ' true, ' + count[2] + ' false, ' + count[0] + ' unknown';
  const rows = [];
  run.atoms.forEach((atom, i) => {
    if (only && !changing.has(i) || part && !atom.name.toLowerCase().includes(part)) return;
    const row = element('tr', undefined, changed.has(i) ? 'new' : '');
    row.append(element('td', atom.name, 'atom'));
    row.append(element('td', signs[now[i]] + ' ' + words[now[i]], classes[now[i]]));
    row.append(element('td', (atom.goal ? 'goal ' : '') + (atom.derived ? 'derived' : ''), 'quiet'));
    if (pastShown) {
      const past = element('td', undefined, 'past');
      history[i].forEach((v, k) => past.append(element('span', signs[v], classes[v] + (k === step ? ' here' : ''))));
      row.append(past);
    }
    rows.push(row);
  });
  fill('atoms', rows);
}
let current = 0;
function show(step) {
  current = Math.max(0, Math.min(last, step));
  const s = run.steps[current];
  get('slider').value = current;
  get('where').textContent = 'step ' + current + ' of ' + last;
  get('action').textContent = s.action || '(start)';
  get('failure').textContent = s.failed ? 'failed ' + s.failure : '';
  fill('read', s.read.length ? s.read.map(r => { const e = element('li'); e.append(element('code', r)); return e; })
                             : [element('li', 'nothing new', 'quiet')]);
  get('end').textContent = s.end;
  showPlan(current);
  showAtoms(current);
  [...get('steps').children].forEach((e, i) => e.classList.toggle('now', i === current));
  const item = get('steps').children[current];
  get('steps').scrollTop = item.offsetTop - get('steps').offsetTop - 60;
}
fill('steps', run.steps.map((s, i) => {
  const e = element('li', undefined, s.failed ? 'f' : '');
  e.append(element('code', s.action || '(start)'));
  if (s.read.length) e.append(element('span', '  ' + s.read.join(', '), 'quiet'));
  e.addEventListener('click', () => show(i));
  return e;
}));
get('slider').max = last;
get('slider').addEventListener('input', () => show(Number(get('slider').value)));
get('back').addEventListener('click', () => show(current - 1));
get('on').addEventListener('click', () => show(current + 1));
get('only').addEventListener('change', () => show(current));
get('filter').addEventListener('input', () => show(current));
document.addEventListener('keydown', event => {
  if (event.target.id === 'filter' || event.target.id === 'slider') return;
  const to = {ArrowRight: current + 1, ArrowLeft: current - 1, Home: 0, End: last}[event.key];
  if (to === undefined) return;
  event.preventDefault();
  show(to);
});
show(0);
)";

}  // namespace

std::string run_page_html(const std::string& title, const std::string& summary, const std::string& data) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>" +
           escape_markup(title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" +
           escape_markup(title) + "</h1>\n<p class=\"quiet\">" + escape_markup(summary) + "</p>" + kBody +
           "<script type=\"application/json\" id=\"run\">" + data + "</script>\n<script>" + kScript +
           "</script></body></html>\n";
}

}  // namespace praxis::belief
