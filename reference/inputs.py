"""Readers of the input files of check.py: OFF and OBJ (FORMAT.md, section 5), classic HDF5 (section 6).

They are not trusted: the hashes in the certificate bind what they return, and check.py looks at ranges and finiteness.
A file that does not fit raises an exception of WRONG.
"""
import itertools, re, struct

LIMIT, MANY = 2 ** 30, 4096
WRONG = ArithmeticError, AttributeError, LookupError, OSError, TypeError, ValueError, struct.error

def fit(condition, why):
    if not condition: raise ValueError(why)
def read_file(path):
    """All bytes of a file; OverflowError if there are more than LIMIT."""
    with open(path, "rb") as file:
        data = b"".join(itertools.islice(iter(lambda: file.read(1 << 20), b""), LIMIT // 2 ** 20 + 1))
    if len(data) > LIMIT: raise OverflowError("too large")
    return data

# ---- section 5: OFF and OBJ
DECIMAL, INDEX = rb"\s+([+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)", rb"\s+0*([0-9]{1,10})"
OFF_HEAD = re.compile(rb"\s*OFF" + 2 * rb"\s+(0|[1-9][0-9]{0,9})" + rb"\s+[0-9]+(?!\S)").match
OFF_ROWS = (re.compile(3 * DECIMAL + rb"(?!\S)").match, re.compile(rb"\s+3" + 3 * INDEX + rb"(?!\S)[^\n]*").match)
OBJ_ROWS = (re.compile(rb"\s*v" + 3 * DECIMAL + rb"(?!\S)").match,
            re.compile(rb"\s*f" + 3 * (INDEX + rb"(?:/\S*)?") + rb"\s*").fullmatch)

def read_mesh(data):
    """(points, triangles) of an OFF or OBJ file; a row that does not match raises AttributeError."""
    data = data.replace(b"\v", b"?")  # which is not white space here
    text, rows = re.sub(rb"#[^\n]*", b"", data), ([], [])
    off = text.lstrip().startswith(b"OFF")
    if off:
        at, counts = OFF_HEAD(text).end(), OFF_HEAD(text).groups()
        for k, _ in ((k, _) for k in (0, 1) for _ in range(int(counts[k]))):
            match = OFF_ROWS[k](text, at)
            rows[k].append(match.groups())
            at = match.end()
    for line in () if off else re.finditer(rb"^[ \t\f\r]*([vf])(?!\S).*", data, re.MULTILINE):
        k = b"vf".index(line[1])
        rows[k].append(OBJ_ROWS[k](line[0]).groups())
    return [tuple(map(float, p)) for p in rows[0]], [tuple(int(v) - (not off) for v in f) for f in rows[1]]

# ---- section 6: HDF5
def read_hdf5(data):
    """The function from the names of two datasets in the root group of an HDF5 file to (points, triangles)."""
    get = lambda layout, at: struct.unpack_from(layout, data, at)
    def messages(at):
        """The first message of each type of an object header, its continuation blocks included."""
        version, left, size = get("<BxH4xI", at)
        found, todo, done = {}, [(at + 16, size)], set()
        for at, size in todo:
            end = at + size
            fit(version == 1 and at not in done and end <= len(data), "object header")
            done.add(at)
            while left and at + 8 <= end:
                kind, length, flags = get("<HHB", at)
                at, left = at + 8 + length, left - 1
                fit(at <= end and not (flags & 2 and kind in (1, 3, 8, 0x10, 0x11)), "message")
                found.setdefault(kind, data[at - length:at])
                todo += [struct.unpack_from("<QQ", data[at - length:at])] if kind == 0x10 else []
        return found
    def rows(name, code):
        """The rows of a dataset of triples (code d: doubles, i: integers of 4 bytes)."""
        found, size = messages(objects[name]), struct.calcsize(code)
        space, n, three = struct.unpack_from("<2s6xQQ", found[1])
        kind, order, bytes_each, form = struct.unpack_from("<BB2xI4s", found[3])
        layout, where, length = struct.unpack_from("<2sQQ", found[8])
        ieee = struct.pack("<2H4BI", 0, 64, 52, 11, 0, 52, 1023)
        good = (kind & 15, order & 1, form) == (0, 0, b"\0\0\x20\0")
        if code == "d": good = (found[3][:4], found[3][8:20]) == (b"\x11\x20\x3f\0", ieee)
        fit(good and bytes_each == size and (space, three) == (b"\1\2", 3) and not {7, 0xB} & {*found}, "dataset")
        fit((layout, length) == (b"\3\1", 3 * n * size) and (n == 0 or where + length <= len(data)), "layout")
        return list(struct.iter_unpack("<3" + code, data[where:where + length] if n else b""))
    signature, sizes, base, root = get("<9s4x2s9xQ32xQ", 0)
    tree, heap = struct.unpack_from("<QQ", messages(root)[0x11])
    magic, size, start = get("<5s3xQ8xQ", heap)
    fit((signature, sizes, base) == (b"\x89HDF\r\n\x1a\n\0", b"\x08\x08", 0), "not classic HDF5")
    fit(magic == b"HEAP\0" and start + size <= len(data), "heap")
    names, objects, todo, done, room = data[start:start + size], {}, [(tree, 256)], set(), size  # names do not overlap
    for node, below in todo:
        magic, kind, level, count = get("<4sBBH", node)
        fit(node not in done and (magic, kind) == ((b"TREE", 0) if below else (b"SNOD", 1)), "group")
        fit(not below or level < below and len(todo) + count <= MANY + 1, "tree")
        done.add(node)
        todo += [(*get("<Q", node + 32 + 16 * k), level) for k in range(count if below else 0)]
        for start, where in [get("<QQ", node + 8 + 40 * k) for k in range(0 if below else count)]:
            name = names[start:names.index(b"\0", start, start + room)]
            fit(name not in objects and len(objects) < MANY, "name used twice, or too many")
            objects[name], room = where, room - len(name) - 1
    return lambda points, faces: (rows(points, "d"), rows(faces, "i"))

# ---- "Inputs" of section 3
def read_inputs(paths, mesh_needed):
    """Bottom, middle and top layer and, if given or needed, the mesh, each as (points, triangles)."""
    fit(1 <= len(paths) <= 4, "one to four input files")
    files = list(map(read_file, paths))
    shell = read_hdf5(files[0]) if len(files) <= 2 else None
    layers = [shell(x, b"mF") for x in (b"mbase", b"mV", b"mtop")] if shell else list(map(read_mesh, files[:3]))
    if len(files) in (2, 4): return [*layers, read_mesh(files[-1])]
    return [*layers, shell(b"ref.V", b"ref.F")] if mesh_needed else layers  # TypeError if there is no mesh
