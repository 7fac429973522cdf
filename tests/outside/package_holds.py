"""package_holds.py SCHEMA FOLDER .. -- datapackage.json is what the schema demands, and what it says of
the files is so: their bytes, sums and columns; keys tell rows apart; numbers are of their types."""

import csv
import hashlib
import json
import math
import os
import sys

try:
    import jsonschema
except ImportError:
    jsonschema = None


def refuse_twins(pairs):
    names = [name for name, _ in pairs]
    assert len(set(names)) == len(names), f"a name twice: {names}"
    return dict(pairs)


def check_table(path, schema):
    fields = schema["fields"]
    names = [field["name"] for field in fields]
    assert len(set(names)) == len(names), f"{path}: a column twice"
    assert set(schema.get("primaryKey", [])) <= set(names), f"{path}: the key is no column"
    key = [names.index(name) for name in schema["primaryKey"]]
    with open(path, newline="", encoding="utf-8") as f:
        head, *rows = csv.reader(f)
    assert head == names, f"{path}: {head}"
    assert len({tuple(row[k] for k in key) for row in rows}) == len(rows), f"{path}: a key twice"
    for row in rows:
        for field, text in zip(fields, row, strict=True):
            number = (int if field["type"] == "integer" else float)(text)
            assert math.isfinite(number), f"{path}: {text}"


def validator(path):
    with open(path, encoding="utf-8") as f:
        schema = json.load(f)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def check(folder, schema):
    with open(folder + "/datapackage.json", encoding="utf-8") as f:
        package = json.load(f, object_pairs_hook=refuse_twins)
    if schema:
        schema.validate(package)
    resources = package["resources"]
    assert len({r["name"] for r in resources}) == len(resources), "a name of a resource twice"
    for r in resources:
        path = os.path.join(folder, r["path"])
        with open(path, "rb") as f:
            data = f.read()
        assert len(data) == r["bytes"], f"{path}: {len(data)} bytes"
        assert "sha256:" + hashlib.sha256(data).hexdigest() == r["hash"], f"{path}: its sum"
        if "schema" in r:
            check_table(path, r["schema"])
    beside = {"datapackage.json", "DATASHEET.md", "SHA256SUMS"}
    there = {os.path.relpath(os.path.join(at, name), folder)
             for at, _, names in os.walk(folder) for name in names}
    there = {name for name in there if not name.startswith("shards/")} - beside
    assert there == {r["path"] for r in resources}, "files that are not resources, or the reverse"
    print(f"{folder}: {len(resources)} resources" + ("" if schema else ", without the schema"))


if __name__ == "__main__":
    SCHEMA = validator(sys.argv[1]) if jsonschema else None
    for name in sys.argv[2:]:
        check(name, SCHEMA)
