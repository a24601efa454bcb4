// Tables, and how numbers are written.

/// @param heads  texts
/// @param rows   of texts, or of elements
function fill(table, heads, rows) {
  const line = (cells, tag) => {
    const row = document.createElement("tr");
    for (const cell of cells) {
      const item = document.createElement(tag);
      if (tag === "th") item.scope = "col";
      item.append(cell);
      row.append(item);
    }
    return row;
  };
  const head = document.createElement("thead"), body = document.createElement("tbody");
  if (heads.some(text => text)) head.append(line(heads, "th"));
  body.append(...rows.map(cells => line(cells, "td")));
  table.replaceChildren(head, body);
}

const fixed = (value, digits) => value === null || value === undefined ? "–" : value.toFixed(digits).replace(/^-(?=0\.?0*$)/, "").replace("-", "−");

/// The nearest of some frequencies within 100 cents: its cents, and its kind if it has one.
function nearestOf(frequency, {frequencies, kinds}) {
  let best = null;
  frequencies.forEach((reference, index) => {
    const cents = 1200 * Math.log2(frequency / reference);
    if (Math.abs(cents) <= 100 && (!best || Math.abs(cents) < Math.abs(best.cents))) best = {cents, kind: kinds[index] || ""};
  });
  return best ? `${fixed(best.cents, 1)} ${best.kind}`.trim() : "–";
}

/// Units of the facts of a run by their names (docs/use/result_file.md); those in `stages` are times.
const units = {
  step: "s", stable_step: "s", elapsed: "s", processor_time: "s", stages: "s", mass: "kg", volume: "m³", smallest_edge: "m",
  largest_edge: "m", largest_eigenfrequency: "Hz", highest_within_5_cents: "Hz", highest_within_50_cents: "Hz", highest: "Hz",
  shift: "cents", elements_per_second: "1/s", memory_bytes: "bytes", root_memory_bytes: "bytes", halo_bytes: "bytes",
};

/// Names and values of nested objects, one by one, with their units.
function flat(object, path = "", above = "") {
  return Object.entries(object).flatMap(([key, value]) => {
    const name = path ? `${path} / ${key}` : key;
    if (value !== null && typeof value === "object") return flat(value, name, key);
    const unit = units[key] ?? units[above];
    return [[name, typeof value === "number" ? short(value) + (unit ? ` ${unit}` : "") : String(value)]];
  });
}
