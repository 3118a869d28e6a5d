// Bundles the sources into one page with a place for documents: lib/gyromode/html/page.html, which the program embeds.
//   node build.mjs           writes it
//   node build.mjs --check   says whether the page kept is what the sources give
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { gunzipSync, gzipSync } from "node:zlib";

const page = new URL("../lib/gyromode/html/page.html", import.meta.url);
const read = (path) => readFileSync(new URL(path, import.meta.url), "utf8");

async function bundled(entry) {
  const result = await build({ entryPoints: [new URL(entry, import.meta.url).pathname], bundle: true, minify: true, write: false, format: "iife", target: "es2022", legalComments: "none", charset: "utf8" });
  return result.outputFiles[0].text;
}

const licences = ["three", "uplot"].map((name) => {
  const { version, homepage } = JSON.parse(read(`node_modules/${name}/package.json`));
  return `${name} ${version}${homepage ? `, ${homepage}` : ""}\n\n${read(`node_modules/${name}/LICENSE`).trim()}`;
}).join("\n\n\n").replaceAll("&", "&amp;").replaceAll("<", "&lt;");

const program = await bundled("src/main.ts");
const style = (await bundled("src/style.css")).trim() + read("node_modules/uplot/dist/uPlot.min.css").trim();
const parts = { style, licences, program: gzipSync(program, { level: 9 }).toString("base64") };
const made = read("page.html").replace(/\{\{(style|licences|program)\}\}/g, (_, part) => parts[part]);

// Compression may differ from one zlib to the next: what counts is what it holds.
const unpacked = (text) => text.replace(/(id="program">)([^<]*)/, (_, before, packed) => before + gunzipSync(Buffer.from(packed, "base64")).toString("utf8"));

if (process.argv[2] === "--check") {
  if (unpacked(readFileSync(page, "utf8")) !== unpacked(made)) {
    console.error("lib/gyromode/html/page.html is not what web/ gives: run  npm --prefix web run build");
    process.exit(1);
  }
} else {
  writeFileSync(page, made);
  console.log(`page.html: ${(made.length / 1000).toFixed(0)} kB, of ${(program.length / 1000).toFixed(0)} kB before packing`);
}
