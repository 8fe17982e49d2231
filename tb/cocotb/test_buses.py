# SPDX-License-Identifier: Apache-2.0
"""horopter_top of the profile vga between bus models that others wrote (cocotbext-axi): two cameras, two sinks, a host.

tb/cocotb/run runs these tests. An answer or a frame that does not come fails, too.
"""
import itertools
import logging
import pathlib
import random
import re
import runpy
import sys
import zlib

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge, with_timeout
from cocotbext.axi import AxiLiteBus, AxiLiteMaster, AxiResp, AxiStreamBus, AxiStreamFrame, AxiStreamSink, AxiStreamSource

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import fpga  # noqa: E402

MAP = runpy.run_path(str(ROOT / "scripts/generate-registers"))["load"]()
REGISTERS = {reg["address"]: reg for reg in MAP["registers"]}
CONSTANTS = {constant["name"]: constant["value"] for constant in MAP["constants"]}
ADDRESS = {reg["name"].upper(): address for address, reg in REGISTERS.items()}
READABLE = {address for address, reg in REGISTERS.items() if reg["access"] != "stream"}
P = {name: int(value) for name, value in re.findall(
    r"int unsigned (\w+) = (\d+);", (ROOT / "rtl/generated/vga/horopter_profile_pkg.sv").read_text(encoding="utf-8"))}
LARGEST_PX, WINDOW_PX = P["WIDTH"] * P["HEIGHT"], P["DSAD_WINDOW"] ** 2
# What registers.md gives no number for: "by profile", and what there is before the first table and frame.
BY_PROFILE = {
    "width": P["WIDTH"], "height": P["HEIGHT"], "lookahead": P["STORE_ROWS"] // 2, "timeout": 2 * LARGEST_PX, "decision": 0,
    "sum_limit": 15 * WINDOW_PX // 4, "self_limit": WINDOW_PX, "alarm_limit": LARGEST_PX // 20, "unsupervised_limit": LARGEST_PX,
    "black_limit": LARGEST_PX // 20 * 19, "white_limit": LARGEST_PX // 20 * 19, "build_size": P["HEIGHT"] << 16 | P["WIDTH"],
    "build_store": P["POOL_BYTES"] // 1024 << 16 | P["STORE_ROWS"], "build_clock": P["CLOCK_KHZ"], "status": 1 << 4,
    "frame_sequence": 0, "map_valid": 0, "map_extent": 0}
RESULT = ("FRAME_SEQUENCE", "FRAME_STATUS", "FRAME_FAULTS_CAMERAS", "FRAME_FAULTS_MACHINE", "FRAME_TABLE_CRC", "FRAME_SKIN",
          "FRAME_UNDECIDABLE", "FRAME_UNSUPERVISED", "FRAME_MISSES")
WIDTH, HEIGHT, SPACING_LOG2, SLOT, SHIFT_PX, CLOCK_STEPS = 64, 24, 4, 3, -6, 2
RESET_CLOCKS = 1  # until every output is in reset
OKAY, SLVERR = AxiResp.OKAY, AxiResp.SLVERR
PAYLOAD = {"m_axis_state_t": ("data", "user", "last"), "m_axis_runs_t": ("data", "last"), "m_axis_objects_t": ("data", "last"), "s_axil_b": ("resp",),
           "s_axil_r": ("resp", "data")}


def after_reset(address):
    """A register's word after reset, as documented; None where nothing is said."""
    reg = REGISTERS.get(address, {"access": "stream"})
    if reg["access"] == "stream" or reg["name"] in BY_PROFILE:
        return BY_PROFILE.get(reg.get("name"))
    key = "constant" if reg["access"] == "ro" else "reset"
    if key == "constant" and not all(key in field for field in reg["fields"]):
        return None
    return sum(field.get(key, 0) << field["lsb"] for field in reg["fields"])


def number(data):
    return int.from_bytes(data, "little")


def pauses(rng, share):
    """Single clocks and long stretches, `share` of them paused."""
    while True:
        yield from itertools.repeat(rng.random() < share, rng.choice((1, 1, 2, 8, 40)))


def texture(rng):
    """Rows of grey levels: squares of three sizes on top of each other, and a little noise."""
    grey = {(step, y, x): rng.randint(-38, 38) for step in (3, 7, 16) for y in range(HEIGHT) for x in range(WIDTH)}
    return [[128 + rng.randint(-2, 2) + sum(grey[step, y // step, x // step] for step in (3, 7, 16)) for x in range(WIDTH)]
            for y in range(HEIGHT)]


def scene(rng, kinds=(0, 1, 1, 2)):
    """(left, right) image. Blocks of the left one are of one grey level (0), on the skin of table() (1), or elsewhere (2)."""
    left, right = texture(rng), texture(rng)
    for start in range(0, WIDTH, 32):
        kind, grey = rng.choice(kinds), rng.randint(40, 200)
        for y, x in itertools.product(range(HEIGHT), range(start, start + 32)):
            left[y][x] = (grey + rng.randint(0, 2), right[y][max(x + SHIFT_PX, 0)], left[y][x])[kind]
    return left, right


def table():
    """Words of a mapping table: on its skin both images differ by SHIFT_PX (hls/include/horopter/hls/table_format.hpp)."""
    columns, rows = ((size - 1 >> SPACING_LOG2) + 2 for size in (WIDTH, HEIGHT))
    pairs = (rows + 1) // 2
    form = {name: value for name, (value, _, _) in fpga.table_format().items()}
    words = [form["magic"] << 16 | form["version"] << 8 | SPACING_LOG2 << 4 | SPACING_LOG2, pairs << 16 | columns,
             HEIGHT << 16 | WIDTH, 1 << 12 | form["fact_words"], 0, 0, WIDTH * HEIGHT, WIDTH * HEIGHT, 0]
    for pair, column, odd in itertools.product(range(pairs), range(columns), (0, 1)):
        x_px, y_px = (column << SPACING_LOG2) + SHIFT_PX, 2 * pair + odd << SPACING_LOG2
        x, y = ((px + form["control_offset_px"]) * form["control_scale"] for px in (x_px, y_px))
        words.append(y << 16 | x)
    return [*words, zlib.crc32(b"".join(word.to_bytes(4, "little") for word in words))]


def runs_of(states):
    for y in range(HEIGHT):
        end = 0
        for state, group in itertools.groupby(states[y * WIDTH:(y + 1) * WIDTH]):
            start, end = end, end + len(list(group))
            yield state << 62 | y << 32 | start << 16 | end - 1


class Machine:
    def __init__(self, dut, purpose):
        logging.getLogger("cocotb.horopter_top").setLevel(logging.ERROR)  # the models tell of every frame and access
        self.dut, self.rng = dut, random.Random(f"{cocotb.RANDOM_SEED} {purpose}")
        cocotb.start_soon(Clock(dut.clk_i, CLOCK_STEPS, "step").start())
        dut.restart_i.value = dut.feedback_i.value = dut.s_axis_test_tvalid.value = 0

        def model(kind, bus, name, **options):  # by exact names, or this Verilator gives the ports' copies inside
            return kind(bus.from_prefix(dut, name, case_insensitive=False), dut.clk_i, dut.rst_ni, False, **options)
        self.host = model(AxiLiteMaster, AxiLiteBus, "s_axil")
        self.cameras = [model(AxiStreamSource, AxiStreamBus, f"s_axis_{side}") for side in ("left", "right")]
        self.states = model(AxiStreamSink, AxiStreamBus, "m_axis_state")
        self.runs = model(AxiStreamSink, AxiStreamBus, "m_axis_runs", byte_lanes=1)
        self.objects = model(AxiStreamSink, AxiStreamBus, "m_axis_objects", byte_lanes=1)
        self.sinks = (self.states, self.runs, self.objects)
        self.taken, self.was_safe = dict.fromkeys(PAYLOAD, 0), False  # beats of each output
        cocotb.start_soon(self._watch())

    async def _watch(self):
        """What AXI demands of every output, and that unsafe_o is the opposite of safe_o, in every clock."""
        signals = {name: [getattr(self.dut, name + part) for part in ("valid", "ready", *parts)]
                   for name, parts in PAYLOAD.items()}
        offered, clocks_in_reset, edge = dict.fromkeys(signals), 0, RisingEdge(self.dut.clk_i)
        while True:
            await edge
            clocks_in_reset = 0 if self.dut.rst_ni.value else clocks_in_reset + 1
            self.was_safe |= bool(self.dut.safe_o.value)
            assert self.dut.safe_o.value != self.dut.unsafe_o.value
            for name, (valid, ready, *parts) in signals.items():
                now = [int(part.value) for part in parts] if valid.value else None
                assert clocks_in_reset <= RESET_CLOCKS or now is None, f"{name}valid in reset"
                assert clocks_in_reset or offered[name] in (None, now), f"{name}: {offered[name]} offered, not taken, then {now}"
                taken = now is not None and bool(ready.value)
                self.taken[name] += taken
                offered[name] = None if taken or clocks_in_reset else now

    def pause(self, share, channels=()):
        """From now on random pauses, `share` of all clocks (0: none, 1: always), of these channels or all."""
        write, read = self.host.write_if, self.host.read_if
        for channel in channels or (*self.cameras, *self.sinks, write.aw_channel, write.w_channel, write.b_channel,
                                    read.ar_channel, read.r_channel):
            channel.set_pause_generator(pauses(random.Random(self.rng.random()), share) if 0 < share < 1 else None)
            channel.pause = share == 1

    async def clocks(self, count):
        await ClockCycles(self.dut.clk_i, count)

    async def within(self, clocks, awaited):
        return await with_timeout(awaited, clocks * CLOCK_STEPS, "step")

    async def answers(self, events):
        """Of accesses that were given one after the other, without waiting."""
        return [(await self.within(100_000, event.wait()), event.data)[1] for event in events]

    def forget(self):
        """Cameras and sinks begin anew."""
        for model in (*self.cameras, *self.sinks):
            model.assert_reset()
        for camera in self.cameras:
            camera.clear()
        for sink in self.sinks:
            while not sink.empty():
                sink.recv_nowait()

    async def reset(self, clocks=RESET_CLOCKS):
        self.dut.rst_ni.value = 0
        await self.clocks(clocks)
        self.forget()
        self.dut.rst_ni.value = 1
        await self.clocks(1)  # what is read at an edge was before it
        assert self.dut.safe_o.value == 0 and self.dut.unsafe_o.value == 1
        await self.clocks(1)

    async def write(self, name, *words):
        events = [self.host.init_write(ADDRESS[name], word.to_bytes(4, "little")) for word in words]
        for answer in await self.answers(events):
            assert answer.resp == OKAY, f"write to {name}: {answer.resp}"

    async def read(self, name):
        answer = (await self.answers([self.host.init_read(ADDRESS[name], 4)]))[0]
        assert answer.resp == OKAY, f"read of {name}: {answer.resp}"
        return number(answer.data)

    async def configure(self, compete=0, prove=0, interlock=2 << 3):
        for name, value in (("CONTROL", 0), ("INTERLOCK", interlock), ("WIDTH", WIDTH), ("HEIGHT", HEIGHT), ("LOOKAHEAD", 8),
                            ("IRQ_ENABLE", 1), ("AGREEMENT", after_reset(ADDRESS["AGREEMENT"]) & ~1 | prove), ("BLIND_SHARE", 0),
                            ("STILL_LIMIT", 0), ("ONE_CAMERA", 0), ("DECISION", compete), ("MAP_SLOT", SLOT),
                            ("MAP_UNDECIDABLE_LIMIT", WIDTH * HEIGHT), ("MAP_CONTROL", 1)):
            await self.write(name, value)
        await self.write("MAP_DATA", *table())
        await self.clocks(20)
        assert await self.read("MAP_STATUS") & 0xF == 0, "upload"
        assert await self.read("MAP_VALID") == 1 << SLOT and await self.read("MAP_CRC") == table()[-1]
        await self.write("TABLE_SELECT", SLOT)
        await self.write("CONTROL", 1)
        assert await self.read("STATUS") & 3 == 1, "not running, or bad_geometry"

    def send(self, pair):
        for camera, image in zip(self.cameras, pair):
            for y, row in enumerate(image):
                camera.send_nowait(AxiStreamFrame(bytes(row), tuser=[int(y == 0)] + [0] * (WIDTH - 1)))

    async def receive(self):
        """The next frame: its registers and states."""
        if not self.dut.irq_o.value:
            await self.within(100_000, RisingEdge(self.dut.irq_o))
        frame = {name: await self.read(name) for name in RESULT}
        assert await self.read("FRAME_SEQUENCE") == frame["FRAME_SEQUENCE"]
        await self.write("IRQ_STATUS", 1)
        await self.clocks(4)  # irq_o falls
        frame["states"] = b""
        for y in range(HEIGHT):
            row = await self.within(9_000, self.states.recv(compact=False))
            assert list(row.tuser) == [int(y == 0)] + [0] * (WIDTH - 1), f"row {y}: {len(row.tuser)} pixels, tuser {row.tuser}"
            frame["states"] += bytes(row.tdata)
        runs = await self.within(9_000, self.runs.recv(compact=False))
        objects = await self.within(9_000, self.objects.recv(compact=False))
        assert objects.tdata[-1] == frame["FRAME_SEQUENCE"] << 48 | len(objects.tdata) - 1, "objects were lost, or miscounted"
        assert list(runs.tdata) == list(runs_of(frame["states"])), "runs are not those of the states"
        for state, name in ((1, "FRAME_SKIN"), (2, "FRAME_UNDECIDABLE"), (3, "FRAME_UNSUPERVISED")):
            assert (count := frame["states"].count(state)) == frame[name], f"{count} states {state}, {name} {frame[name]}"
        return frame

    async def run(self, pairs):
        for pair in pairs:
            self.send(pair)
        frames = [await self.receive() for _ in pairs]
        await self.clocks(200)
        assert all(sink.empty() and sink.idle() for sink in self.sinks), "more came out than went in"
        return frames


def check_equal(frames, expected, what):
    for n, (frame, right) in enumerate(zip(frames, expected, strict=True)):
        different = [f"{name} {frame[name]}, not {right[name]}" for name in RESULT if frame[name] != right[name]]
        places = [place for place, (a, b) in enumerate(zip(frame["states"], right["states"])) if a != b]
        assert not different and not places, f"{what}: frame {n}: {different}, {len(places)} other states, first {places[:5]}"


@cocotb.test()
async def registers_after_reset(dut):
    """Every address has its documented value, or answers SLVERR; so do bytes, halfwords and more, aligned or not."""
    machine = Machine(dut, "registers")
    accesses = [(address, 4) for address in range(0, 4096, 4)]
    accesses += [(machine.rng.randrange(0x1B0), machine.rng.choice((1, 1, 2, 2, 3, 4, 7, 12))) for _ in range(500)]
    for share in (0, 0.5):
        machine.pause(share)
        await machine.reset()
        for answer, (address, size) in zip(await machine.answers([machine.host.init_read(*a) for a in accesses]), accesses):
            words = range(address & ~3, address + size, 4)
            assert answer.resp == (OKAY if READABLE.issuperset(words) else SLVERR), f"{address:#x}, {size} bytes: {answer.resp}"
            for place, byte in enumerate(answer.data, address):
                value = after_reset(place & ~3) if place & ~3 in READABLE else None
                assert value is None or byte == value >> 8 * (place & 3) & 0xFF, f"byte {place:#x}: {byte:#x}, not of {value:#x}"
    cocotb.log.info("%d accesses; %d of %d registers have a documented value", 2 * len(accesses),
                  sum(after_reset(address) is not None for address in READABLE), len(READABLE))


@cocotb.test()
async def random_writes(dut):
    """Random writes, queued without waiting, and reads beside them: what is written is read, and nothing else changes."""
    machine = Machine(dut, "writes")
    rng, host, accesses = machine.rng, machine.host, 0
    values = {address: after_reset(address) for address, reg in REGISTERS.items() if reg["access"] == "rw"}

    def expect(address, data, strobes):
        """The answer to a write of a word; the values after it."""
        reg = REGISTERS.get(address, {"access": "ro", "locked": False})
        locked = reg["locked"] and values[ADDRESS["CONTROL"]]
        if locked or reg["access"] == "ro" or (reg["access"] == "stream" and strobes != 15):
            return SLVERR
        if reg["access"] == "rw":
            mask = sum(0xFF << 8 * byte for byte in range(4) if strobes >> byte & 1) & (1 << reg["bits"]) - 1
            values[address] = values[address] & ~mask | data & mask
        return OKAY

    await machine.reset()
    for batch in range(60):
        machine.pause(rng.choice((0, 0.3, 0.7)))
        events, expected = [], []
        for _ in range(rng.randint(1, 12)):
            address = rng.choice((*values, *REGISTERS, *range(0, 4080, 64))) + rng.randrange(4)
            data, words = rng.randbytes(rng.choice((1, 2, 3, 4, 4, 4, 7, 9))), {}
            for place, byte in enumerate(data, address):
                word, strobes = words.get(place & ~3, (0, 0))
                words[place & ~3] = word | byte << 8 * (place & 3), strobes | 1 << (place & 3)
            events.append(host.init_write(address, data))
            expected.append(max(expect(word, *part) for word, part in words.items()))
        reads = [host.init_read(ADDRESS["ID"], 4) for _ in range(rng.randint(0, 8))]
        found = [answer.resp for answer in await machine.answers(events)]
        assert found == expected, f"batch {batch}: {found}, not {expected}"
        assert {number(answer.data) for answer in await machine.answers(reads)} <= {after_reset(ADDRESS["ID"])}
        aw, w, b = host.write_if.aw_channel, host.write_if.w_channel, host.write_if.b_channel
        for _ in range(6):  # any strobes, none among them, and data before the address
            address, data, strobes = rng.choice(list(values)), rng.getrandbits(32), rng.randrange(16)
            await w.send(w._transaction_obj(wdata=data, wstrb=strobes))
            await aw.send(aw._transaction_obj(awaddr=address, awprot=rng.randrange(8)))
            answer = await machine.within(9_000, b.recv())
            assert int(answer.bresp) == expect(address, data, strobes), f"write to {address:#x}, strobes {strobes:04b}"
        for answer in await machine.answers([host.init_read(address, 4) for address in values]):
            right, name = values[answer.address], REGISTERS[answer.address]["name"]
            assert number(answer.data) == right, f"batch {batch}: {name} {number(answer.data):#x}, not {right:#x}"
        accesses += len(events) + len(reads) + 6 + len(values)
    cocotb.log.info("%d accesses", accesses)


@cocotb.test()
async def frames_with_pauses_equal_those_without(dut):
    machine, seen = Machine(dut, "frames"), set()
    for compete, prove in ((0, 0), (1, 0), (0, 1)):
        pairs, expected = [scene(machine.rng) for _ in range(8)], None
        for share in (0, 0.3, 0.6):
            await machine.reset()
            machine.pause(share)
            await machine.configure(compete, prove)
            frames = await machine.run(pairs)
            expected = expected or frames
            check_equal(frames, expected, f"pauses {share}, compete {compete}, prove {prove}")
            assert [frame["FRAME_SEQUENCE"] for frame in frames] == list(range(1, 9))
            assert prove or not any(frame["FRAME_FAULTS_CAMERAS"] or frame["FRAME_FAULTS_MACHINE"] for frame in frames)
        counts = [sum(frame["states"].count(state) for frame in expected) for state in range(4)]
        cocotb.log.info("compete %d, prove %d: 3 times 8 frames of %dx%d, states %s", compete, prove, WIDTH, HEIGHT, counts)
        seen |= {state for state in range(4) if counts[state]}
    assert not machine.was_safe, "safe_o rose, and nobody restarted"
    assert seen == {0, 1, 2, 3}, f"only states {seen}"


@cocotb.test()
async def safe_only_after_a_restart(dut):
    """safe_o rises with the frame after the key, if two were good before it; an alarm takes it away until the same again."""
    machine, was = Machine(dut, "safe"), False
    machine.pause(0.3)
    await machine.reset()
    await machine.configure(interlock=2 << 3 | 1 << 2)
    await machine.write("ALARM_LIMIT", WIDTH * HEIGHT // 10)
    key, wrong = CONSTANTS["restart_key"], CONSTANTS["restart_key"] ^ 1
    for n, (written, good, safe) in enumerate(((key, 1, 0), (key, 1, 0), (wrong, 1, 0), (key, 1, 1), (wrong, 1, 1), (key, 0, 0),
                                               (key, 1, 0), (key, 1, 0), (key, 1, 1))):
        await machine.write("RESTART", written)
        machine.was_safe = False
        frame = (await machine.run([scene(machine.rng, (2,) if good else (1,))]))[0]
        assert frame["FRAME_STATUS"] & 3 == (2 if good else 1), f"frame {n}: FRAME_STATUS {frame['FRAME_STATUS']:#x}"
        assert dut.safe_o.value == safe and machine.was_safe == (safe or was), f"frame {n}: safe_o {dut.safe_o.value}"
        was = bool(safe)


async def in_the_middle(machine, stop):
    """Stops the machine eight times in the middle of frames; those after that are the same as without stops."""
    pairs = [scene(machine.rng) for _ in range(2)]
    await machine.reset()
    await machine.configure()
    expected = await machine.run(pairs)
    for n in range(8):
        for pair in pairs:
            machine.send(pair)
        machine.pause(machine.rng.choice((0, 0.3, 0.6)))
        await machine.clocks(machine.rng.randint(1, 9_000))
        await stop(n)
        check_equal(await machine.run(pairs), expected, f"after stop {n}")


@cocotb.test()
async def reset_in_the_middle(dut):
    """Of frames, and of reads and writes that are under way."""
    machine = Machine(dut, "reset in the middle")

    async def stop(n):
        for _ in range(4):
            machine.host.init_read(ADDRESS["ID"], 64)
            last = machine.host.init_write(ADDRESS["SUM_LIMIT"], bytes(16))
        await machine.clocks(machine.rng.randint(1, 30))
        await machine.reset(machine.rng.randint(RESET_CLOCKS, 5))
        await machine.clocks(50)
        assert last.data is None, "the last write was answered"
        assert await machine.read("SUM_LIMIT") == BY_PROFILE["sum_limit"] and await machine.read("MAP_VALID") == 0
        await machine.configure()
    await in_the_middle(machine, stop)


@cocotb.test()
async def disabled_in_the_middle(dut):
    """CONTROL.enable = 0: a beat that is offered stays, and nothing comes after it."""
    machine = Machine(dut, "disabled in the middle")

    async def stop(n):
        if n % 2:
            machine.pause(1, machine.sinks)
            await machine.clocks(machine.rng.randint(2, 600))
        await machine.write("CONTROL", 0)
        await machine.clocks(4)
        due = {name: machine.taken[name] + int(getattr(dut, name + "valid").value) for name in PAYLOAD if name[0] == "m"}
        await machine.clocks(machine.rng.randint(1, 300))
        machine.pause(0, machine.sinks)
        await machine.clocks(300)
        for name, count in due.items():
            assert machine.taken[name] == count, f"{name}: {machine.taken[name] - count} beats more than were offered"
        machine.forget()
        await machine.write("IRQ_STATUS", 1)
        await machine.write("CONTROL", 1)
    await in_the_middle(machine, stop)
