// What joins the records of a page to dygraphs: choosing one, unpacking it, and one time axis for both pictures.
#pragma once

namespace host_sim::reports {

constexpr char kZoomFrame[] = R"html(<noscript><p>Zooming needs scripts; the pictures above do not.</p></noscript>
<p class="choose"><label for="zoom-choice">Record </label><select id="zoom-choice"></select></p>
<figure class="zoom"><figcaption id="zoom-title"></figcaption><p id="zoom-signals-legend"></p><div id="zoom-signals"></div><p id="zoom-errors-legend"></p><div id="zoom-errors"></div></figure>
)html";

constexpr char kZoomScript[] = R"js(
(() => {
  const records = JSON.parse(document.getElementById('zoom-records').textContent);
  const at = (id) => document.getElementById(id);
  const ink = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const unpacked = (record, text) => {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), view = new DataView(bytes.buffer);
    return Array.from({length: bytes.length / 2},
      (_, i) => record.low + (record.high - record.low) * (view.getInt16(2 * i, true) + 32767) / 65534);
  };
  const rows = (record, curves) => curves[0].map((_, i) => [record.start + i * record.step, ...curves.map((c) => c[i])]);
  const legend = (colours) => (data) => data.series.map((series, i) =>
    `<span><i style="border-color:var(${colours[i]})"></i>${series.label}${series.yHTML ? ': ' + series.yHTML : ''}</span>`)
    .join('') + (data.xHTML ? `<span>at ${data.xHTML} s</span>` : '');
  let graphs = [], busy = false;
  const together = (graph, first) => {
    if (first || busy) return;
    busy = true;
    for (const other of graphs) if (other !== graph) other.updateOptions({dateWindow: graph.xAxisRange()});
    busy = false;
  };
  const show = (record, dateWindow) => {
    const curves = record.curves.map((curve) => unpacked(record, curve.values));
    const errors = curves.slice(1).map((curve) => curve.map((value, i) => value - curves[0][i]));
    const make = (place, values, labels, colours, name, height) => new Dygraph(at(place), rows(record, values), {
      labels: ['time', ...labels], colors: colours.map(ink), ylabel: name, height, dateWindow,
      xlabel: place === 'zoom-errors' ? 'time (s)' : '', labelsDiv: at(place + '-legend'), legend: 'always', legendFormatter: legend(colours),
      gridLineColor: ink('--grid'), axisLineColor: ink('--frame'), strokeWidth: 1.3, digitsAfterDecimal: 6,
      axes: {x: {axisLabelWidth: 60}, y: {axisLabelWidth: 62, valueFormatter: (value) => +value.toPrecision(4)}}, drawCallback: together});
    for (const graph of graphs) graph.destroy();
    at('zoom-title').textContent = record.title;
    const names = record.curves.map((c) => c.label), colours = record.curves.map((c) => c.colour);
    graphs = [make('zoom-signals', curves, names, colours, record.quantity, 260)];
    if (errors.length > 0)
      graphs.push(make('zoom-errors', errors, names.slice(1).map((n) => 'error, ' + n), colours.slice(1),
        'error' + record.quantity.slice(record.quantity.lastIndexOf(' (')), 170));
  };
  const choice = at('zoom-choice');
  records.forEach((record, i) => choice.add(new Option(record.title, i)));
  const shown = () => show(records[choice.value], graphs.length > 0 ? graphs[0].xAxisRange() : null);
  choice.addEventListener('change', shown);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', shown);
  shown();
})();
)js";

}  // namespace host_sim::reports
