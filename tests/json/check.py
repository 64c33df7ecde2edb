"""Asks a validator that is not ours about scenes: check.py HEADLESS SCHEMA SCENE...

Every scene must be valid. Then each is broken at random, by a seed that is fixed, and both the validator and the reader are asked.
What the reader accepts, the schema must accept: else it would underline what is right. Of names that nobody knows, of wrong types and
of bodies that are missing the reader must accept none.
"""
import json, os, random, subprocess, sys, tempfile
import jsonschema

headless, schema_path, scenes = sys.argv[1], sys.argv[2], [s for s in sys.argv[3:] if not s.endswith("schema.json")]
schema = json.load(open(schema_path))
jsonschema.Draft202012Validator.check_schema(schema)
valid = jsonschema.Draft202012Validator(schema)
wrong = 0
texts = {}
for path in scenes:
    texts[path] = json.load(open(path))
    for e in valid.iter_errors(texts[path]):
        wrong += 1
        print("%s: %s: %s" % (path, "/".join(map(str, e.path)), e.message[:150]))
if wrong:
    sys.exit("json: scenes that the schema refuses: %d" % wrong)
print("json: the schema accepts %d scenes" % len(scenes))

rng = random.Random(26)
small = sorted((p for p in scenes if os.path.getsize(p) < 6000), key=os.path.basename)
work = tempfile.mkdtemp()
path = os.path.join(work, "broken.json")

def places(value, found):
    """Every (object or array, key) in the scene."""
    for key, child in (value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()):
        found.append((value, key))
        places(child, found)
    return found

def wrong_type(v):
    if isinstance(v, bool): return rng.choice([1, "true"])
    if isinstance(v, (int, float)): return rng.choice([True, "1", [1], {}])
    if isinstance(v, str): return rng.choice([3.5, [v], True])
    if isinstance(v, list): return rng.choice([3, {"x": 1}, "0 0", v + [[]]])
    return rng.choice([3, [v], "none"])

def rename(at, key):
    if not isinstance(at, dict): return None
    at[key + rng.choice("sx_")] = at.pop(key)
    return "name"
def retype(at, key):
    at[key] = wrong_type(at[key])
    return "type"
def strange(at, key):
    at[key] = rng.choice([-1, 1e39, 0, -0.0, 1e-50, 2.5, "", None, [], {}, "weld", "circle", 10**20])
    return "value"
def drop(at, key):
    del at[key]
    return "dropped"

seen = {}
for i in range(700):
    scene = json.loads(json.dumps(texts[rng.choice(small)]))
    at, key = rng.choice(places(scene, []))
    what = rng.choice([rename, rename, retype, retype, strange, drop])(at, key)
    if what is None:
        continue
    with open(path, "w") as f:
        json.dump(scene, f)
    run = subprocess.run([headless, "--hash", path, "--steps", "0"], capture_output=True, text=True)
    reads, fits = run.returncode == 0, valid.is_valid(scene)
    if run.returncode not in (0, 1):
        sys.exit("json: the reader died of %s\n%s" % (json.dumps(scene)[:2000], run.stderr))
    if reads and not fits:
        sys.exit("json: the reader accepts and the schema refuses (%s, %s): %s" % (what, key, [e.message[:200] for e in valid.iter_errors(scene)]))
    if reads and what in ("name", "type"):
        sys.exit("json: accepted although the %s of %s is wrong: %s" % (what, key, json.dumps(scene)[:600]))
    if not reads and "broken.json:" not in run.stderr:
        sys.exit("json: refused without a word: %s" % run.stderr)
    if not reads and "broken.json:0:" in run.stderr and "memory" not in run.stderr:
        sys.exit("json: refused without a line: %s" % run.stderr)
    seen[what, reads, fits] = seen.get((what, reads, fits), 0) + 1
os.remove(path)
os.rmdir(work)
both = sum(n for (w, r, f), n in seen.items() if not r and not f)
reader = sum(n for (w, r, f), n in seen.items() if not r and f)
fine = sum(n for (w, r, f), n in seen.items() if r)
if min(both, reader, fine) == 0:
    sys.exit("json: the broken scenes are all of one kind: %s" % seen)
print("json: of %d scenes broken at random %d are refused by reader and schema, %d by the reader alone, %d still mean something"
      % (both + reader + fine, both, reader, fine))
