# SPDX-License-Identifier: Apache-2.0
"""The longest path of a flat netlist in the cells of constraints/gates.lib, for scripts/budget. As a program: tests itself."""
import re

CLOCK_TO_OUTPUT_NS = 0.6
MEMORY_ACCESS_NS = 8.0  # synchronous SRAM of a 0.5 um process
TREE = 16  # what one output drives; more of them take buffers in between
BUFFER_NS = 0.6


def cell_delays(library):
    """Per cell of the library ns without load and ns for each input that it drives: of table values at two loads, in pF."""
    found = {}
    for name, text in re.findall(r"cell \((\w+)\) \{(.*?)\n  \}", library, re.S):
        rows = [[float(v) for v in row.split(",")] for row in re.findall(r'"([\d., ]+)"', text.split("cell_rise", 1)[1])[:1]]
        capacitance = float(re.search(r"capacitance : ([\d.]+)", text)[1])
        slope = (rows[0][1] - rows[0][0]) / (1.0 - 0.01)
        found[name] = (rows[0][0], slope * capacitance)
    return found


def longest_path(module, library):
    """ns from register or memory to register or memory, and the names of both ends. Loops are an error."""
    delays = cell_delays(library)
    cells = module["cells"]

    def is_output(cell, port):  # yosys does not know the directions of the library's cells
        return port == "Y" if cell["type"] in delays else cell["port_directions"][port] == "output"

    driver, sinks, starts, ends = {}, {}, {}, []
    for name, cell in cells.items():
        gate = cell["type"] in delays
        for port, bits in cell["connections"].items():
            for bit in bits:
                if not isinstance(bit, int):
                    continue
                if is_output(cell, port):
                    if gate:
                        driver[bit] = name
                    else:
                        starts[bit] = (MEMORY_ACCESS_NS if cell["type"].startswith("$mem") else CLOCK_TO_OUTPUT_NS, name)
                else:
                    sinks[bit] = sinks.get(bit, 0) + 1
                    if not gate:
                        ends.append((bit, name))
    arrival = dict(starts)

    def drive(bit):
        count, levels = sinks.get(bit, 0), 0
        while count > TREE:
            count, levels = -(-count // TREE), levels + 1
        return count, levels * BUFFER_NS

    def arrive(target):
        stack = [target]
        while stack:
            bit = stack[-1]
            if bit in arrival and arrival[bit] is not None:
                stack.pop()
                continue
            if bit not in driver:  # an input of the chip
                arrival[bit] = (0.0, "input")
                continue
            cell = cells[driver[bit]]
            inputs = [b for port, bits in cell["connections"].items() for b in bits
                      if isinstance(b, int) and not is_output(cell, port)]
            missing = [b for b in inputs if arrival.get(b) is None]
            if missing:
                if bit in arrival:
                    raise ValueError(f"a loop of gates through {driver[bit]}")
                arrival[bit] = None
                stack += missing
                continue
            own, per_input = delays[cell["type"]]
            count, tree = drive(bit)
            latest = max((arrival[b] for b in inputs), default=(0.0, "constant"))
            arrival[bit] = (latest[0] + own + per_input * count + tree, latest[1])
        return arrival[target]

    worst = (0.0, "", "")
    for bit, end in ends:
        ns, start = arrive(bit)
        worst = max(worst, (ns, start, end))
    return worst


def self_test():
    """Paths counted by hand: gates of 0.15 ns and 0.1 ns for each input that they drive."""
    library = '  cell (NAND2) {\n    capacitance : 0.1; cell_rise (one) { values ("0.15, 1.14", "0, 0") }\n  }\n'
    ends = {"D": "input", "Q": "output"}

    def cell(kind, **connections):
        return {"type": kind, "port_directions": ends, "connections": {port: [bit] for port, bit in connections.items()}}

    def check(cells, expected_ns):
        ns, start, end = longest_path({"cells": cells}, library)
        if abs(ns - expected_ns) > 1e-9 or (start, end) != ("from", "to"):
            raise SystemExit(f"gate_timing: {ns} ns from '{start}' to '{end}' instead of {expected_ns} from 'from' to 'to'")

    chain = {"from": cell("$_DFF_P_", D=9, Q=1), "first": cell("NAND2", A=1, Y=2), "second": cell("NAND2", A=1, B=2, Y=3),
             "to": cell("$_DFF_P_", D=3, Q=4)}
    check(chain, 0.6 + 2 * 0.25)
    # 17 inputs are driven by two buffers.
    load = {f"load{n}": cell("$_DFF_P_", D=2, Q=10 + n) for n in range(TREE)}
    check(chain | load, 0.6 + (0.15 + 2 * 0.1 + BUFFER_NS) + 0.25)
    check(chain | {"from": cell("$mem_v2", D=9, Q=1)}, MEMORY_ACCESS_NS + 2 * 0.25)
    try:
        longest_path({"cells": chain | {"first": cell("NAND2", A=3, Y=2)}}, library)
    except ValueError:
        return
    raise SystemExit("gate_timing: a loop of gates was not noticed")


if __name__ == "__main__":
    self_test()
