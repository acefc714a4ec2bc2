// validate.mjs -- runs gltf-validator over files: no error, and no warning that the source had not.
//
//   node validate.mjs FILE.glb [SOURCE.glb]
// Prints the counts; exit status 1 when FILE is worse than that.
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

const limit = { maxIssues: 0 };

async function report(path) {
  const result = await validator.validateBytes(new Uint8Array(readFileSync(path)), limit);
  return result.issues;
}

// Times each kind of warning was given, by code.
function warnings(issues) {
  const counts = new Map();
  for (const message of issues.messages) {
    if (message.severity === 1) counts.set(message.code, (counts.get(message.code) ?? 0) + 1);
  }
  return counts;
}

function print(path, issues) {
  console.log(
    `${path}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ` +
      `${issues.numInfos} infos, ${issues.numHints} hints`);
}

const [path, source] = process.argv.slice(2);
if (!path) {
  console.error("usage: node validate.mjs FILE.glb [SOURCE.glb]");
  process.exit(2);
}
const issues = await report(path);
print(path, issues);
const known = new Map();
if (source) {
  const before = await report(source);
  print(source, before);
  for (const [code, count] of warnings(before)) known.set(code, count);
}

let bad = issues.numErrors;
for (const message of issues.messages) {
  if (message.severity === 0) {
    console.error(`error ${message.code} at ${message.pointer ?? ""}: ${message.message}`);
  }
}
for (const [code, count] of warnings(issues)) {
  if (count <= (known.get(code) ?? 0)) continue;
  console.error(`warning ${code}: ${count} times, ${known.get(code) ?? 0} in the source`);
  ++bad;
}
process.exit(bad === 0 ? 0 : 1);
