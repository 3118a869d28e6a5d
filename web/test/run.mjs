// The page in a real browser (Debian's Chromium, headless): every kind of document opened, sorted, filtered, hovered, chosen from, played, printed, in
// the dark and on a phone. Nothing may be said on the console, nothing fetched, and every number shown is one of the document.
//   node test/run.mjs PROGRAM ROOT [FOLDER for screenshots]
import { chromium } from "playwright-core";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import assert from "node:assert/strict";

const [, , program, root, pictures] = process.argv;
const folder = mkdtempSync(join(tmpdir(), "gyromode-report-"));
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const run = (...words) => execFileSync(program, words, { cwd: root, stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 28 });

const documents = {
  geos: ["modes", "models/geos.toml", "--lowest", "12", "--shapes", "--participation"],
  rotor: ["modes", "models/rotors/two_discs.toml", "--lowest", "8", "--shapes", "--sensitivity"],
  springs: ["modes", "models/three_springs.toml", "--shapes", "--units", "Hz"],
  growing: ["modes", "models/rigid_body_intermediate.toml", "--shapes"],
  campbell: ["campbell", "models/rotors/two_discs.toml", "--spin", "0:12000rpm:25", "--lowest", "6"],
  critical: ["critical", "models/rotors/two_discs.toml", "--sensitivity"],
  map: ["critical", "models/rotors/two_discs.toml", "--over", "bearing[*].kxx,bearing[*].kyy=1e5:1e9:12"],
  stability: ["stability", "models/rotating_frame.toml", "--vary", "spin=0:3:30"],
  structure: ["structure", "models/geos.toml", "--at", "1"],
  cycle: ["structure", "models/geos_rotated.toml", "--at", "1"],
  count: ["count", "models/geos.toml", "--below", "40rpm"],
  motion: ["response", "models/geos.toml", "--force", "impulse:theta1=10", "--until", "60", "--step", "1"],
  unbalance: ["response", "models/rotors/two_discs.toml", "--unbalance", "disk1=1e-4", "--spin", "0:6000rpm:40"],
  frequencies: ["response", "models/three_springs.toml", "--force", "x=1", "--frequencies", "10Hz:200Hz:40"],
};

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"] });

/** A page whose every word on the console and every request is a fault. */
async function opened(file, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, ...options });
  const page = await context.newPage();
  page.faults = [];
  page.on("console", (m) => { if (!/GPU stall|GL Driver Message/.test(m.text())) page.faults.push(`console: ${m.text()}`); });
  page.on("pageerror", (e) => page.faults.push(`error: ${e.message}`));
  page.on("request", (r) => { if (r.url() !== `file://${file}`) page.faults.push(`request: ${r.url().slice(0, 100)}`); });
  await page.goto(`file://${file}`);
  await page.waitForSelector("article", { timeout: 20000 });
  return page;
}

const numbersOf = (value, all = new Set()) => {
  if (typeof value === "number") all.add(value);
  else if (value && typeof value === "object") for (const v of Object.values(value)) numbersOf(v, all);
  return all;
};
const perRadian = { "rad/s": 1, Hz: 1 / (2 * Math.PI), rpm: 60 / (2 * Math.PI), "%": 100 };

/** Every <data> is a number of the document, and its text is that number, rounded, in its unit. */
async function expectTrue(page, json) {
  const all = numbersOf(json);
  const shown = await page.$$eval("data", (es) => es.map((e) => ({ value: Number(e.value), text: e.textContent, unit: e.dataset.unit })));
  assert.ok(shown.length > 0, "numbers are shown");
  for (const { value, text, unit } of shown) {
    assert.ok(all.has(value), `${value} is no number of the document`);
    const words = Number(text.replace("%", "").trim()), due = value * (unit ? perRadian[unit] : 1);
    assert.ok(Math.abs(words - due) <= 0.05 * Math.abs(due) + 1e-12 || text === "∞", `${text} stands for ${due}`);
  }
}

async function expectAccessible(page, name) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  const serious = violations.filter((v) => v.impact === "serious" || v.impact === "critical");
  assert.deepEqual(serious.map((v) => `${name}: ${v.id}: ${v.nodes[0].html.slice(0, 120)}`), []);
}

let failed = 0;
async function test(name, body) {
  try {
    await body();
    console.log(`ok    ${name}`);
  } catch (e) {
    ++failed;
    console.log(`FAIL  ${name}: ${e.message}`);
  }
}

const made = {};
for (const [name, words] of Object.entries(documents)) {
  const file = join(folder, `${name}.json`);
  try { run(...words, "-o", file); } catch (e) { if (e.status !== 4) throw e; }
  made[name] = JSON.parse(readFileSync(file, "utf8"));
  run("report", file, "-o", join(folder, `${name}.html`));
}

for (const name of Object.keys(documents)) {
  await test(`${name}: shown, true, accessible, silent`, async () => {
    for (const colorScheme of ["light", "dark"]) {
      const page = await opened(join(folder, `${name}.html`), { colorScheme });
      assert.equal(await page.$$eval("[role=alert]", (e) => e.length), 0, "no damage is said");
      await page.evaluate(() => { for (const d of document.querySelectorAll("details")) d.open = true; });
      await page.waitForTimeout(300);
      await expectTrue(page, made[name]);
      await expectAccessible(page, `${name}, ${colorScheme}`);
      if (pictures) {
        await page.evaluate(() => { for (const d of document.querySelectorAll("details")) d.open = false; });
        await page.screenshot({ path: join(pictures, `${name}-${colorScheme}.png`), fullPage: true });
      }
      assert.deepEqual(page.faults, []);
      await page.context().close();
    }
  });
}

await test("a table sorts, filters and goes to the clipboard", async () => {
  const page = await opened(join(folder, "geos.html"), { permissions: ["clipboard-read", "clipboard-write"] });
  const table = page.locator("table", { has: page.locator("caption", { hasText: "Modes of" }) });
  const places = () => table.locator("tbody tr td:first-child").allTextContents();
  const before = await places();
  await table.getByRole("button", { name: "#" }).focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  assert.deepEqual(await places(), [...before].reverse());
  await page.getByLabel("Filter").first().fill("nutation");
  assert.equal((await places()).length, 1);
  await page.getByRole("button", { name: "Copy as CSV" }).first().click();
  const csv = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(csv, /^mode,omega,frequency_hz,/);
  assert.ok(made.geos.modes.some((m) => csv.includes(String(m.omega))), "all digits are copied");
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

await test("a branch is hovered, chosen, and reached by the keyboard", async () => {
  const page = await opened(join(folder, "campbell.html"));
  const chart = page.locator(".canvas").first();
  await chart.scrollIntoViewIfNeeded();
  const box = await chart.locator(".u-over").boundingBox();
  let seen = false;
  for (let k = 1; k < 12 && !seen; ++k) {
    await page.mouse.move(box.x + 0.5 * box.width, box.y + (k / 12) * box.height);
    seen = await page.locator(".tip").first().isVisible();
  }
  assert.ok(seen, "a tip is shown");
  await page.mouse.down();
  await page.mouse.up();
  assert.match(await page.locator(".chosen").innerText(), /Branch \d/);
  await chart.focus();
  for (const key of ["ArrowRight", "ArrowUp", "ArrowRight", "Enter"]) await page.keyboard.press(key);
  assert.match(await page.locator(".chosen").innerText(), /whirl/);
  await expectTrue(page, made.campbell);
  await page.getByLabel("Excitation orders").fill("1, 2.5");
  await page.getByLabel("Excitation orders").press("Enter");
  assert.match(await page.locator(".chart .legend").innerText(), /order 2.5/);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

await test("a mode plays, and its points are those of the shape", async () => {
  for (const name of ["geos", "rotor"]) {
    const page = await opened(join(folder, `${name}.html`));
    const phase = () => page.evaluate(() => document.querySelector(".scene canvas").scene.phase);
    const first = await phase();
    await page.waitForFunction((from) => document.querySelector(".scene canvas").scene.phase !== from, first, { timeout: 20000 });
    await page.getByRole("button", { name: "Pause" }).focus();
    await page.keyboard.press("Enter");
    const rested = await phase();
    await page.waitForTimeout(200);
    assert.equal(await phase(), rested);
    const seen = await page.evaluate(() => {
      const { scene } = document.querySelector(".scene canvas");
      scene.phase = 0.7;
      scene.drawNow();
      return { positions: [...scene.positions], amplitude: scene.amplitude, place: document.querySelector(".moving select").selectedOptions[0].textContent };
    });
    const d = made[name], mode = d.modes[Number(seen.place.split(":")[0]) - 1];
    const points = d.geometry.points, off = seen.positions.length / 3 - points.length;  // corners of the body come first
    const sizes = mode.displacements.re.map((r, k) => Math.hypot(...r, ...mode.displacements.im[k]));
    const move = (k, i) => Math.cos(0.7) * mode.displacements.re[k][i] - Math.sin(0.7) * mode.displacements.im[k][i];
    // The scale is the page's own: it is read off one entry, and must serve all.
    let k0 = 0, i0 = 0;
    points.forEach((_, k) => [0, 1, 2].forEach((i) => { if (Math.abs(move(k, i)) > Math.abs(move(k0, i0))) { k0 = k; i0 = i; } }));
    const scale = (seen.positions[3 * (k0 + off) + i0] - points[k0][i0]) / move(k0, i0);
    const extent = Math.max(...points.flat().map(Math.abs));
    assert.ok(scale > 0 && Math.max(...sizes) > 0);
    points.forEach((p, k) => [0, 1, 2].forEach((i) => assert.ok(Math.abs(seen.positions[3 * (k + off) + i] - p[i] - scale * move(k, i)) < 1e-6 * extent, `point ${k}`)));
    assert.deepEqual(page.faults, []);
    await page.context().close();
  }
});

await test("shapes as one block (version 2) are drawn as well, two modes beside each other", async () => {
  const file = join(folder, "block.json");
  run("modes", "models/rotors/two_discs.toml", "--lowest", "4", "--shapes", "--schema", "2", "-o", file);
  run("report", file, "-o", join(folder, "block.html"));
  const page = await opened(join(folder, "block.html"));
  assert.equal(await page.locator(".moving canvas").count(), 1);
  assert.match(await page.locator(".beside").innerText(), /theta_x1/);
  await page.getByLabel("beside").selectOption({ index: 3 });
  await page.waitForTimeout(200);
  await expectTrue(page, JSON.parse(readFileSync(file, "utf8")));
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

await test("printed, and on a phone", async () => {
  const page = await opened(join(folder, "rotor.html"), { viewport: { width: 390, height: 800 } });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 391, `the page is ${wide} px wide`);
  const pdf = await page.pdf({ format: "A4" });
  assert.ok(pdf.length > 10000);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

await test("what a document says stays text", async () => {
  const evil = structuredClone(made.geos);
  evil.model.title = `</script><img src=x onerror="window.ran = 1">`;
  evil.structure.in_phase[0] = `"><svg onload=window.ran=1>`;
  evil.structure.in_phase[1] = "long".repeat(2500);
  evil.modes[2].name = "<!--<script>";
  writeFileSync(join(folder, "evil.json"), JSON.stringify(evil));
  run("report", join(folder, "evil.json"), "-o", join(folder, "evil.html"));
  const page = await opened(join(folder, "evil.html"), { viewport: { width: 390, height: 800 } });
  assert.equal(await page.evaluate(() => window.ran), undefined);
  assert.equal(await page.$$eval("main img", (e) => e.length), 0);
  assert.equal(await page.locator("h2").innerText(), evil.model.title);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 391);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

await test("200 000 points in time, and a window without a mode", async () => {
  const long = structuredClone(made.motion), n = 200000;
  Object.assign(long, { labels: ["x"], t: Array.from({ length: n }, (_, k) => 0.01 * k), q: Array.from({ length: n }, (_, k) => [Math.sin(0.01 * k)]) });
  const empty = structuredClone(made.springs);
  Object.assign(empty, { modes: [], coverage: { ...empty.coverage, found: 0, counted: 0, window: [0, 1e-9] } });
  for (const [name, document] of Object.entries({ long, empty })) {
    writeFileSync(join(folder, `${name}.json`), JSON.stringify(document));
    run("report", join(folder, `${name}.json`), "-o", join(folder, `${name}.html`));
    const page = await opened(join(folder, `${name}.html`));
    assert.deepEqual(await page.$$eval("[role=alert]", (e) => e.map((x) => x.textContent)), []);
    assert.deepEqual(page.faults, []);
    await page.context().close();
  }
});

await test("200 spins of 20 branches: below a megabyte, first seen within a second", async () => {
  const spins = Array.from({ length: 200 }, (_, k) => 2 * k + 1 / 3), many = structuredClone(made.campbell);
  const from = many.branches[0], over = (v) => spins.map((_, k) => v(k));
  Object.assign(many, { spins, coverage: over(() => "complete"), stability: over(() => "stable"), growth_rate: over(() => 0), events: [], excitation: [] });
  many.branches = Array.from({ length: 20 }, (_, b) => ({ ...from, omega: over((k) => 100 * (b + 1) + Math.sqrt(k + b + 0.1)), whirl: over(() => "forward"), energy_sign: over(() => 1), slope: over((k) => Math.sin(k + b)), error_bound: over((k) => 1e-10 * Math.cos(k)), coverage: over(() => "complete") }));
  writeFileSync(join(folder, "many.json"), JSON.stringify(many));
  run("report", join(folder, "many.json"), "-o", join(folder, "many.html"));
  const size = readFileSync(join(folder, "many.html")).length;
  assert.ok(size < 1e6, `${size} bytes`);
  const page = await opened(join(folder, "many.html"));
  const paint = await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime);
  console.log(`      ${(size / 1000).toFixed(0)} kB, first paint after ${paint?.toFixed(0)} ms`);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

await browser.close();
rmSync(folder, { recursive: true });
console.log(failed === 0 ? "all passed" : `${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
