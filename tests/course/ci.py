"""The examples for GitHub Classroom and GitLab, run as the services run them, without one.
     ci.py KIND FILE STUDENT TEACHER WORK [BUILT]      KIND: github or gitlab; STUDENT, TEACHER: git repositories; WORK: an empty folder;
                                                       BUILT: the engine that an earlier run has built from TEACHER; it is not built again
   Every command comes from FILE. What a service would do by itself (checkouts, graders that run a command, artifacts) is done here. A command
   finds only programs (by PATH) that the image has, or that a package brings which the example installs, with what that depends on.
   The last line: points by the commands that ask for a criterion (github), tests and failures of the JUnit report (gitlab).
"""
import glob, os, re, shlex, subprocess, sys, xml.etree.ElementTree as tree
import yaml

kind, file, student, teacher, work, *built = sys.argv[1], *map(os.path.abspath, sys.argv[2:])
BASE = {"github": ["git", "sudo", "ca-certificates"], "gitlab": []}[kind]      # beside what Debian calls essential


def stop(text):
    sys.exit("%s: %s" % (os.path.basename(file), text))


class Strict(yaml.SafeLoader):      # a key that stands twice is a mistake that other parsers let pass
    def construct_mapping(self, node, deep=False):
        keys = [self.construct_object(k) for k, _ in node.value]
        if len(set(keys)) != len(keys):
            stop("a key stands twice in line %d" % (node.start_mark.line + 1))
        return super().construct_mapping(node, deep)


def known(where, given, *names):
    for k in given:
        if k not in names:
            stop("%s has an unknown key %s" % (where, k))
    return given


# ------------------------------------------------------------------------------------ packages, by what dpkg says of those here
status = {}
for block in open("/var/lib/dpkg/status", encoding="utf-8").read().split("\n\n"):
    field = dict(re.findall(r"^([\w-]+): *(.*)$", block, re.M))
    if "installed" in field.get("Status", "").split():
        status[field["Package"]] = field
gives = {}
for name, field in status.items():
    for p in [name] + re.findall(r"[\w.+-]+(?=[ ,(]|$)", re.sub(r"\(.*?\)", "", field.get("Provides", ""))):
        gives.setdefault(p, name)


def closure(names):
    have, todo = set(), list(names)
    while todo:
        name = gives.get(todo.pop())
        if not name or name in have:
            continue
        have.add(name)
        for need in (status[name].get("Depends", "") + "," + status[name].get("Pre-Depends", "")).split(","):
            others = [re.sub(r"[ (:].*", "", o.strip()) for o in need.split("|")]
            todo += [o for o in others if o in gives][:1]
    return have


def programs(packages, to):
    packages = closure(packages)
    listed = subprocess.run(["dpkg", "-L", *sorted(packages)], capture_output=True, text=True).stdout.split("\n")
    files = {f for f in listed if re.match(r"(/usr)?/s?bin/[^/]+$", f)}
    for link in os.listdir("/etc/alternatives"):      # awk is mawk, cc is gcc
        target = os.path.realpath("/etc/alternatives/" + link)
        if target in files or target.replace("/usr", "", 1) in files:
            files.add("/usr/bin/" + link)
    for f in files:
        if os.access(f, os.X_OK) and not os.path.lexists(to + "/" + os.path.basename(f)):
            os.symlink(f, to + "/" + os.path.basename(f))


image = work + "/bin"
os.makedirs(image)
programs([n for n, f in status.items() if f.get("Essential") == "yes"] + ["apt", "dpkg"] + BASE, image)


def installed(packages):
    for p in packages:
        if p not in status:
            stop("the package %s is not installed here, so nobody knows whether its programs suffice" % p)
    programs(packages, image)
    if "libc6-dev" not in closure(packages):
        stop("no package brings the C library's headers")


# ------------------------------------------------------------------------------------------------------------ commands
BRING = "cp -r '%s' teacher/build && t=$(date +@%%s.%%N) && find teacher/build -exec touch -d $t {} +" % (built or [""])[0]      # newer than the clone
MEMORY = subprocess.run(["ccache", "-k", "cache_dir"], capture_output=True, text=True).stdout.strip() if os.path.exists("/usr/bin/ccache") else ""


def run(command, cwd, check=True):
    env = {"PATH": image, "HOME": work, "LANG": "C.UTF-8", "GIT_CONFIG_NOSYSTEM": "1", "WEFT_TEACHER": teacher}
    if os.path.exists("/usr/bin/ccache"):      # the same compilers, with a memory
        os.makedirs(work + "/ccache", exist_ok=True)
        for c in ("gcc", "cc"):
            if os.path.lexists(image + "/" + c) and not os.path.lexists(work + "/ccache/" + c):
                os.symlink("/usr/bin/ccache", work + "/ccache/" + c)
        env.update({k: v for k, v in os.environ.items() if k.startswith("CCACHE_") or k == "COURSE_WARN"}, CCACHE_DIR=MEMORY, CCACHE_BASEDIR=work, CCACHE_NOHASHDIR="1")
        env["PATH"] = work + "/ccache:" + image
    for part in re.split(r"&&|\n", command):      # what is installed is looked up, not fetched
        words = [w for w in shlex.split(part) if w != "sudo"] if "apt-get" in part else []
        if words[:2] == ["apt-get", "install"]:
            installed([w for w in words[2:] if not w.startswith("-")])
    shell = "apt-get() { :; }; sudo() { \"$@\"; }; set -eo pipefail\n" + command
    if built:
        shell = "git() { command git \"$@\"; [ \"$1\" != clone ] || { %s; }; }; " % BRING + shell
    r = subprocess.run(["/bin/bash", "-c", shell], cwd=cwd, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(r.stdout, end="")
    if check and r.returncode:
        stop("%s: exit status %d" % (command, r.returncode))
    return r.returncode == 0


def clone(what, to):
    subprocess.run(["git", "clone", "-q", "--depth", "1", "file://" + what, to], check=True)
    if built and what == teacher:
        subprocess.run(["bash", "-c", BRING], check=True, cwd=place)


def kept(paths, cwd):
    for p in paths:
        if not glob.glob(cwd + "/" + p):
            stop("there is no %s to be kept" % p)


whole = yaml.load(open(file, encoding="utf-8"), Strict)
place = work + "/place"
if kind == "github":
    os.makedirs(place)
    known("the workflow", whole, "name", True, "permissions", "jobs")      # to YAML 1.1 the word on is true
    (job,) = whole["jobs"].values()
    known("the job", job, "runs-on", "steps")
    points = most = 0
    results = {}
    for step in job["steps"]:
        known("a step", step, "uses", "with", "run", "id", "env", "if")
        given = step.get("with", {})
        uses = step.get("uses", "").split("@")[0]
        if "run" in step:
            run(step["run"], place)
        elif uses == "actions/checkout":
            known(uses, given, "path", "repository", "token")
            if given.get("repository", "${{ vars.WEFT_TEACHER }}") != "${{ vars.WEFT_TEACHER }}":
                stop("it checks out " + given["repository"])
            clone(teacher if "repository" in given else student, place + "/" + given["path"])
        elif uses == "classroom-resources/autograding-command-grader":
            known(uses, given, "test-name", "command", "max-score")
            good = run(given["command"], place, check=False)
            results["${{ steps.%s.outputs.result }}" % step["id"]] = good
            points, most = points + good * given["max-score"], most + given["max-score"]
        elif uses == "classroom-resources/autograding-grading-reporter":
            for r in known(uses, given, "runners")["runners"].split(","):
                results.pop(step["env"][r.upper() + "_RESULTS"])
            if results:
                stop("not all results are reported")
        elif uses == "actions/upload-artifact":
            kept([known(uses, given, "name", "path")["path"]], place)
        else:
            stop("nobody knows what %s does" % step)
    print("%g of %g" % (points, most))
else:
    clone(student, place)
    (job,) = whole.values()
    known("the job", job, "image", "variables", "script", "artifacts")
    run("\n".join(job["script"]), place)
    known("artifacts", job["artifacts"], "when", "paths", "reports")
    kept(job["artifacts"]["paths"] + list(job["artifacts"]["reports"].values()), place)
    suites = tree.parse(place + "/" + job["artifacts"]["reports"]["junit"]).getroot()
    cases = list(suites.iter("testcase"))
    print("%d of %d" % (sum(c.find("failure") is None for c in cases), len(cases)))
