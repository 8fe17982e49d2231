# SPDX-License-Identifier: Apache-2.0
"""Gates (NAND2 equivalents) of SystemVerilog by yosys of Debian 12: for scripts/budget and scripts/windows. How they are
counted stands in constraints/budget.yaml."""
import collections
import json
import re
import subprocess
import sys

import fpga

ROOT = fpga.ROOT
LIBRARY = ROOT / "constraints/gates.lib"

# Of everything below a top, to {work}/gates.json and, flat, to {work}/gates.flat.json.
GATES = """
proc; opt; wreduce; peepopt; opt_clean
memory_dff; memory_share; opt_mem; memory_collect
alumacc; share; opt -full
techmap -map +/techmap.v -map constraints/ripple.v; opt -fast
dfflegalize -cell $_DFF_P_ 01 -cell $_DFFE_PP_ 01 -cell $_SDFF_PN?_ 01 -cell $_SDFFE_PN?P_ 01
opt_expr; opt_merge; opt_clean
abc -liberty {library} -script +strash;ifraig;scorr;dc2;dc2;strash;dch,-f;amap,-m,-F,20,-A,50,-C,2000
opt_clean
write_json {work}/gates.json
flatten
write_json {work}/gates.flat.json
"""


def yosys(work, name, files, commands):
    """Runs `commands` of yosys on files, in `work`; the netlist by module that they write to NAME.json."""
    work.mkdir(parents=True, exist_ok=True)
    listed = " ".join(str(f.relative_to(ROOT)) for f in files)
    netlist, script = work / f"{name}.json", work / f"{name}.ys"
    script.write_text(f"read_verilog -sv -D SYNTHESIS {listed}\n{commands}\n", encoding="utf-8")
    run = subprocess.run(["yosys", "-q", "-l", work / f"{name}.log", "-s", script], cwd=ROOT, capture_output=True, text=True,
                         check=False)
    if run.returncode:
        sys.exit(f"{run.stderr.strip()}\nyosys failed, see {(work / name).relative_to(ROOT)}.log; "
                 f"repeat: yosys -s {script.relative_to(ROOT)}")
    return json.loads(netlist.read_text())["modules"]


def synthesise(work, files, hierarchy):
    """The modules below what `hierarchy`, a command of yosys, says, in gates."""
    return yosys(work, "gates", files, f"{hierarchy}\n" + GATES.format(library=LIBRARY.relative_to(ROOT), work=work.relative_to(ROOT)))


class GateCount:
    def __init__(self, modules, rules):
        self.modules, self.rules = modules, rules
        self.areas = {n: float(a) for n, a in re.findall(r"cell \((\w+)\) \{\s*area : ([\d.]+);", LIBRARY.read_text())}

    def own(self, module):
        """Gates and memory bits of a module's own cells, and its instances by name."""
        weights = self.rules["weights"]
        gates, bits, enables, instances = 0.0, 0, collections.Counter(), {}
        for name, cell in self.modules[module]["cells"].items():
            kind = cell["type"]
            if kind in self.modules:
                instances[name] = kind
            elif kind in self.areas:
                gates += self.areas[kind]
            elif match := re.fullmatch(r"\$_(S?)DFF(E?)_\w+_", kind):
                gates += weights["flip_flop"] + (weights["synchronous_reset"] if match[1] else 0)
                if match[2]:
                    enables[cell["connections"]["E"][0]] += 1
            elif kind in ("$mem", "$mem_v2"):
                size = int(cell["parameters"]["SIZE"], 2) * int(cell["parameters"]["WIDTH"], 2)
                if size >= self.rules["memory_bits_from"]:
                    bits += size
                else:  # as flip-flops with an enable a word, and a multiplexer tree for each port that reads
                    words, ports = int(cell["parameters"]["SIZE"], 2), int(cell["parameters"]["RD_PORTS"], 2)
                    gates += size * weights["flip_flop"] + words * self.enable(size // words)
                    gates += ports * (words - 1) * int(cell["parameters"]["WIDTH"], 2) * self.areas["MUX2"]
            elif kind not in ("$scopeinfo", "$assert", "$assume", "$cover"):
                sys.exit(f"budget: unknown cell '{kind}' in {module}")
        return gates + sum(map(self.enable, enables.values())), bits, instances

    def enable(self, flip_flops):
        """Gates of an enable shared by so many flip-flops: what is cheaper."""
        return min(self.rules["weights"]["clock_gate"], flip_flops * self.areas["MUX2"])

    def whole(self, module):
        gates, bits, instances = self.own(module)
        for kind in instances.values():
            below = self.whole(kind)
            gates, bits = gates + below[0], bits + below[1]
        return gates, bits

    def parity_bits(self, module):
        """Of the memories of horopter_ram with PARITY: one bit beside each word of whole bytes; of the pool's four."""
        cells, bits = self.modules[module]["cells"].values(), 0
        for cell in cells:
            if cell["type"] in self.modules:
                bits += self.parity_bits(cell["type"])
            elif cell["type"] in ("$mem", "$mem_v2") and "horopter_ram_bank" in module:
                words, width = int(cell["parameters"]["SIZE"], 2), int(cell["parameters"]["WIDTH"], 2)
                beside = 4 if width == 36 else int(width % 8 == 1 and width > 1)
                bits += words * beside if words * width >= self.rules["memory_bits_from"] else 0
        return bits

    def leaves(self, rows):
        """(path, gates, bits) of every instance that a row may name: those of the top, and those of what it opens."""
        opened = {path.rsplit(".", 1)[0] for row in rows for path in row["instances"] if "." in path[1:]}
        found, queue = [], [("", "horopter_top")]
        while queue:
            path, module = queue.pop()
            gates, bits, instances = self.own(module)
            if path in ("", *opened):
                if path == "" or gates or bits:
                    found.append((path or ".", gates, bits))
                queue += [(f"{path}.{n}".lstrip("."), kind) for n, kind in instances.items()]
            else:
                found.append((path, *self.whole(module)))
        return found
