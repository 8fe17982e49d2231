#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the ECP5's cells can do and yosys does not use: changes to a netlist in yosys's JSON, between synthesis and placing.

  scripts/ecp5.py FILE MODULE    all but the output registers, and copies of much that would do without: rtl/equivalence
                                 proves the result equal
"""
import itertools
import json
import pathlib
import sys


def _users(module):
    """(cell, port) of all that a bit is an input of; (None, None) for a port of the module."""
    users = {}
    for name, cell in module["cells"].items():
        for port, bits in cell["connections"].items():
            if cell["port_directions"][port] == "input":
                for bit in bits:
                    users.setdefault(bit, []).append((name, port))
    for port in module["ports"].values():
        for bit in port["bits"]:
            users.setdefault(bit, []).append((None, None))
    return users


def _registers_behind(cells, users, outputs):
    """What takes a cell's outputs, {port: bit}: ({port: flip-flop}, clock, enable or "1"), where each that is read goes to one
    flip-flop and nowhere else, and these are alike, without reset; else None."""
    chosen, kinds = {}, set()
    for port, bit in outputs.items():
        readers = users.get(bit, [])
        if not readers:
            continue
        name, entry = readers[0]
        if len(readers) != 1 or name is None or cells[name]["type"] != "TRELLIS_FF" or entry != "DI":
            return None
        ports, parameters = cells[name]["connections"], cells[name]["parameters"]
        enable = parameters["CEMUX"].strip()
        if (parameters["CLKMUX"] != "CLK" or parameters["REGSET"] != "RESET" or ports.get("LSR", ["0"]) != ["0"]
                or enable not in ("1", "CE")):  # it may invert its enable
            return None
        kinds.add((ports["CLK"][0], "1" if enable == "1" else ports["CE"][0]))
        chosen[port] = name
    return (chosen, *kinds.pop()) if len(kinds) == 1 else None


def _move_in(cells, cell, chosen):
    for port, name in chosen.items():
        cell["connections"][port] = cells[name]["connections"]["Q"]
        del cells[name]
    return len(chosen)


def use_output_registers(module):
    """yosys does not use the output registers of ECP5's block memories: where every bit that is read goes to a flip-flop
    of the same clock and nowhere else, that flip-flop moves into the memory. With words of 36 bits (Lattice's PDPW16KD) the
    outputs of both ports are the word that port B reads. Changes the netlist; returns how many flip-flops moved."""
    cells, users = module["cells"], _users(module)
    moved = 0
    for cell in [c for c in cells.values() if c["type"] == "DP16KD" and c["parameters"]["REGMODE_B"] == "NOREG"]:
        ports = cell["connections"]
        wide = int(cell["parameters"]["DATA_WIDTH_A"], 2) == 36
        if not wide and any(users.get(bit) for i in range(18) for bit in ports[f"DOA{i}"]):
            continue  # the write port is read, too
        sides = "AB" if wide else "B"
        found = _registers_behind(cells, users, {f"DO{side}{i}": ports[f"DO{side}{i}"][0] for side in sides for i in range(18)})
        if found is None or found[1] != ports["CLKB"][0]:
            continue
        for side in sides:
            cell["parameters"][f"REGMODE_{side}"] = "OUTREG"
            ports[f"OCE{side}"] = [found[2]]
        moved += _move_in(cells, cell, found[0])
    return moved


def use_product_registers(module):
    """The same for the multipliers. Changes the netlist; returns how many flip-flops moved."""
    cells, users = module["cells"], _users(module)
    moved = 0
    for cell in [c for c in cells.values() if c["type"] == "MULT18X18D"]:
        found = _registers_behind(cells, users, {f"P{i}": cell["connections"][f"P{i}"][0] for i in range(36)})
        if found is None:
            continue
        cell["parameters"] |= {"REG_OUTPUT_CLK": "CLK0", "REG_OUTPUT_CE": "CE0", "REG_OUTPUT_RST": "RST0"}
        for port, net in ("CLK0", found[1]), ("CE0", found[2]), ("RST0", "0"):
            cell["connections"][port] = [net]
            cell["port_directions"][port] = "input"
        moved += _move_in(cells, cell, found[0])
    return moved


def _table_value(init, inputs, values):
    """Output of a look-up table whose inputs A to D are nets or constants."""
    index = sum(values.get(net, net == "1") << place for place, net in enumerate(inputs))
    return init >> index & 1


def _support(init, inputs):
    """Nets that the output of a look-up table depends on, in the order of its inputs."""
    nets = [net for net in dict.fromkeys(inputs) if isinstance(net, int)]
    needed = []
    for net in nets:
        others = [other for other in nets if other != net]
        for case in itertools.product((0, 1), repeat=len(others)):
            values = dict(zip(others, case))
            if _table_value(init, inputs, {**values, net: 0}) != _table_value(init, inputs, {**values, net: 1}):
                needed.append(net)
                break
    return needed


def _half_with(half, out, table):
    """Table and inputs of half a carry cell that has the look-up table with the output `out` merged into it; None where it
    does not fit. Where the table of all four inputs is 1 the half passes the carry on; where it is 0 it gives the carry that
    the first four entries, a table of inputs A and B alone, tell (CCU2C in yosys's cells_sim.v)."""
    init, inputs = half
    nets = []
    for net in inputs:
        nets += _support(*table) if net == out else [net] if isinstance(net, int) else []
    nets = list(dict.fromkeys(nets))
    if len(nets) > 4:
        return None
    cases = []  # values of the nets, whether the carry passes, the carry if not
    for case in itertools.product((0, 1), repeat=len(nets)):
        values = dict(zip(nets, case))
        inner = {**values, out: _table_value(*table, values)}
        cases.append((values, _table_value(init, inputs, inner), _table_value(init, [*inputs[:2], "0", "0"], inner)))
    for order in itertools.permutations(nets):
        placed = [*order, *["1"] * (4 - len(nets))]
        entries, fits = {}, True
        for values, passes, carry in cases:
            index = sum(values.get(net, 1) << place for place, net in enumerate(placed))
            fits &= entries.setdefault(index, passes) == passes
            if not passes:
                fits &= entries.setdefault(index & 3, carry) == carry
        if fits:
            return sum(value << index for index, value in entries.items()), placed
    return None


def merge_into_carries(module):
    """Half a carry cell has a look-up table of four inputs, of which yosys uses two or three for the summands: a look-up
    table in front of it that feeds nothing else moves in where it fits. Changes the netlist; returns how many did."""
    cells, users = module["cells"], _users(module)
    merged, before = 0, -1
    while merged != before:
        before = merged
        for name in [n for n, c in cells.items() if c["type"] == "LUT4"]:
            ports = cells[name]["connections"]
            out = ports["Z"][0]
            readers = users.get(out, [])
            if not readers or not all(cell and cells[cell]["type"] == "CCU2C" and port[0] in "ABCD" and port[1] in "01"
                                      and cells[cell]["parameters"][f"INJECT1_{port[1]}"] == "NO" for cell, port in readers):
                continue
            table = int(cells[name]["parameters"]["INIT"], 2), [ports[p][0] for p in "ABCD"]
            halves = {}
            for cell, place in {(cell, port[1]) for cell, port in readers}:
                half = int(cells[cell]["parameters"][f"INIT{place}"], 2), [cells[cell]["connections"][p + place][0] for p in "ABCD"]
                halves[cell, place] = _half_with(half, out, table)
            if None in halves.values():
                continue
            for (cell, place), (init, inputs) in halves.items():
                cells[cell]["parameters"][f"INIT{place}"] = f"{init:016b}"
                for port, net in zip("ABCD", inputs):
                    old = cells[cell]["connections"][port + place][0]
                    users[old].remove((cell, port + place))
                    users.setdefault(net, []).append((cell, port + place))
                    cells[cell]["connections"][port + place] = [net]
            for port in "ABCD":
                users[ports[port][0]].remove((name, port))
            del cells[name]
            merged += 1
    return merged


def invert_resets(module):
    """A flip-flop of the ECP5 can invert its reset itself; yosys gives it an inverter. Of a reset of the whole machine that is
    one look-up table for thousands of flip-flops, and its way once more. Changes the netlist; returns how many resets were."""
    cells, users = module["cells"], _users(module)
    inverted = 0
    for cell in list(cells.values()):
        if cell["type"] != "LUT4":
            continue
        ports = cell["connections"]
        table = int(cell["parameters"]["INIT"], 2), [ports[p][0] for p in "ABCD"]
        support = _support(*table)
        if len(support) != 1 or _table_value(*table, {support[0]: 1}):
            continue
        for name, port in users.get(ports["Z"][0], []):
            flip_flop = cells.get(name)
            if port == "LSR" and flip_flop["type"] == "TRELLIS_FF" and flip_flop["parameters"]["LSRMUX"].strip() == "LSR":
                flip_flop["connections"]["LSR"] = [support[0]]
                flip_flop["parameters"]["LSRMUX"] = "INV"
                inverted += 1
    return inverted


def _instance(name):
    return name.lstrip("\\").rsplit(".", 1)[0]


def _load(readers):
    """What they are to a net: the flip-flops of a slice have one enable and one reset."""
    return sum(1 if port not in ("CE", "LSR") else 1 / 4 for _, port in readers)


def _shares(readers, most):
    """Readers in shares of a load of at most `most`, neighbours by name together; a new instance begins one if half of that is
    full."""
    shares = [[]]
    for reader in sorted(readers):
        other = shares[-1] and _instance(shares[-1][-1][0]) != _instance(reader[0])
        if _load([*shares[-1], reader]) > most or (other and _load(shares[-1]) >= most / 2):
            shares.append([])
        shares[-1].append(reader)
    return shares


def copy_drivers(module, most=32):
    """nextpnr copies nothing: what a flip-flop or a look-up table drives may lie all over the part. One with a load of more
    than `most` gets copies, each with a share of its readers. Changes the netlist; returns how many copies were made."""
    cells, users = module["cells"], _users(module)
    free = itertools.count(1 + max(bit for cell in cells.values() for bits in cell["connections"].values() for bit in bits
                                   if isinstance(bit, int)))
    copies = 0

    def copy(name, output):
        nonlocal copies
        copies += 1  # in the name, which is then no other copy's
        copied = f"{name}_copy_{copies}"
        if copied in cells:
            sys.exit(f"ecp5: there is a cell {copied} already")
        made = json.loads(json.dumps(cells[name]))
        made["connections"][output] = [next(free)]
        made["attributes"].pop("BEL", None)
        cells[copied] = made
        for port, bits in made["connections"].items():
            if made["port_directions"][port] == "input":
                for bit in bits:
                    users.setdefault(bit, []).append((copied, port))
        return copied, made["connections"][output][0]

    drivers = {cell["connections"]["Z"][0]: name for name, cell in cells.items() if cell["type"] == "LUT4"}
    for kind, output in ("LUT4", "Z"), ("TRELLIS_FF", "Q"), ("TRELLIS_FF", "Q"):  # once more: for what copies read
        for name in [n for n, c in cells.items() if c["type"] == kind]:
            net = cells[name]["connections"][output][0]
            readers = users.get(net, [])
            if _load(readers) <= most or any(cell is None for cell, _ in readers):
                continue
            shares = _shares(readers, most)
            data = cells[name]["connections"].get("DI", [None])[0] if kind == "TRELLIS_FF" else None
            table = drivers.get(data) if len(users.get(data, [])) == 1 else None  # it lies in the flip-flop's slice
            for share in shares[1:]:
                copied, own = copy(name, output)
                if table:
                    users[data].remove((copied, "DI"))
                    cells[copied]["connections"]["DI"] = [copy(table, "Z")[1]]
                for cell, port in share:
                    cells[cell]["connections"][port] = [own if bit == net else bit for bit in cells[cell]["connections"][port]]
            moved = {reader for share in shares[1:] for reader in share}
            users[net] = [reader for reader in users[net] if reader not in moved]  # with those that copies have become
    return copies


def check_drivers(module):
    """Every net that is read has one driver; a sentence and the end where it has none or several. nextpnr places a design
    all the same."""
    drivers = {}
    for name, cell in module["cells"].items():
        for port, bits in cell["connections"].items():
            if cell["port_directions"][port] != "input":
                for bit in bits:
                    drivers.setdefault(bit, []).append(name)
    for port in module["ports"].values():
        if port["direction"] == "input":
            for bit in port["bits"]:
                drivers.setdefault(bit, []).append("a port")
    for bit, readers in _users(module).items():
        if isinstance(bit, int) and readers != [(None, None)] and len(drivers.get(bit, [])) != 1:
            sys.exit(f"ecp5: {readers[0][0]}, {readers[0][1]}: its net has {len(drivers.get(bit, []))} drivers, expected one")


def improve(module):
    """All of the above. Changes the netlist; returns a sentence for each that found something."""
    found = ((merge_into_carries(module), "look-up tables merged into carry cells"),
             (use_output_registers(module), "flip-flops moved into the output registers of block memories"),
             (use_product_registers(module), "flip-flops moved into the output registers of multipliers"),
             (invert_resets(module), "resets inverted by their flip-flops"),
             (copy_drivers(module), "copies of what drives many"))
    check_drivers(module)
    return [f"{count} {what}" for count, what in found if count]


def main():
    file, name = pathlib.Path(sys.argv[1]), sys.argv[2]
    design = json.loads(file.read_text(encoding="utf-8"))
    module = design["modules"][name]
    print(f"{name}: {merge_into_carries(module)} look-up tables merged into carry cells, {invert_resets(module)} resets inverted, "
          f"{copy_drivers(module, most=12)} copies", file=sys.stderr)
    check_drivers(module)
    file.write_text(json.dumps(design), encoding="utf-8")


if __name__ == "__main__":
    main()
