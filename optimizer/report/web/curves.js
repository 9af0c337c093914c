// SPDX-License-Identifier: BSD-3-Clause
// From the course of a run to plots: one figure each, made once and fed from then on.
import uPlot from "uplot";

// Okabe and Ito: hues that differ for colour-blind eyes too.
const colours = [
  "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c6d31", "#7f7f7f"
];
const height = 260;

const ink = () => getComputedStyle(document.body).color;

/** What is to be drawn: [{title, series: [{label, values, band?}]}] over the generations. */
export function plotsOf(course) {
  const {curves} = course;
  const plots = [{
    title: `Fitness: ${course.measure}`,
    x: curves.generation,
    series: [
      {label: "mean", values: curves.mean, low: curves.mean_low, high: curves.mean_high},
      {label: "best of training", values: curves.best, dash: [5, 4]},
      {label: "median", values: curves.median},
      {label: "champion, validated", values: curves.champion},
    ],
  }];
  if (curves.species.length > 0)
    plots.push({title: "Species: members", x: curves.logged_generation, series: stacked(curves.species)});
  const complexity = ["mean_links", "most_links", "mean_hidden"].filter((name) => curves.logged[name]);
  if (complexity.length > 0)
    plots.push({
      title: "Complexity of networks",
      x: curves.logged_generation,
      series: complexity.map((name) => ({label: name, values: curves.logged[name]})),
    });
  if (curves.logged.sigma)
    plots.push({
      title: "Step size",
      x: curves.logged_generation,
      series: [{label: "sigma", values: curves.logged.sigma}],
    });
  for (const {name, best, low, high} of curves.parameters)
    plots.push({
      title: name,
      x: curves.generation,
      series: [{label: "best of the generation", values: best, low, high}],
    });
  return plots;
}

/** Each species drawn from the top of the one before, the lowest last. */
function stacked(species) {
  const floor = species[0].sizes.map(() => 0);
  return species
    .map(({id, sizes}) => ({
      label: `species ${id}`,
      values: sizes.map((size, i) => (floor[i] += size)),
      fill: true,
    }))
    .reverse();
}

/** Lines of one plot with the edges of their bands, as uPlot wants them. */
function columnsOf(plot) {
  const data = [plot.x];
  const series = [{label: "generation"}];
  const bands = [];
  plot.series.forEach(({label, values, low, high, dash, fill}, i) => {
    const stroke = colours[i % colours.length];
    data.push(values);
    series.push({label, stroke, width: 2, dash, fill: fill ? stroke + "aa" : undefined});
    if (!low) return;
    data.push(high, low);
    const edge = {stroke: "transparent", points: {show: false}};
    series.push({label: `${label} high`, ...edge}, {label: `${label} low`, ...edge});
    bands.push({series: [series.length - 2, series.length - 1], fill: stroke + "2e"});
  });
  return {data, series, bands};
}

export class Curves {
  #figures = new Map();  // title -> {chart, shape}

  constructor(parent) {
    this.parent = parent;
    new ResizeObserver(() => this.#fit()).observe(parent);
  }

  get count() { return this.#figures.size; }

  show(course) {
    for (const plot of plotsOf(course)) {
      const {data, series, bands} = columnsOf(plot);
      const shape = series.map(({label}) => label).join("\n");
      const known = this.#figures.get(plot.title);
      if (known?.shape === shape) {
        known.chart.setData(data);
        continue;
      }
      const figure = known?.figure ?? this.parent.appendChild(document.createElement("figure"));
      known?.chart.destroy();
      const axis = {stroke: ink, grid: {stroke: "#80808030"}, ticks: {stroke: "#80808030"}};
      const chart = new uPlot(
        {
          title: plot.title,
          width: figure.clientWidth - 16,
          height,
          scales: {x: {time: false}},
          axes: [{...axis, label: "generation", labelSize: 18}, axis],
          legend: {show: plot.series.length < 9},
          series,
          bands,
        },
        data, figure);
      this.#figures.set(plot.title, {chart, shape, figure});
    }
  }

  #fit() {
    for (const {chart, figure} of this.#figures.values())
      chart.setSize({width: figure.clientWidth - 16, height});
  }
}
