#!/usr/bin/env python3
"""against_schema.py SCHEMA.json DOCUMENTS [--mutated]: holds JSON documents, one a line, against a schema (draft 2020-12).

Prints what does not conform, a line each. With --mutated: conforming documents are spoilt in every place, one at a time (a key
taken away, a key misspelt, a value of another type), and what the schema lets pass is printed instead, with how many were tried on the
last line.
"""
import copy
import json
import sys

from jsonschema import Draft202012Validator


def objects(value, path=()):
    if isinstance(value, dict):
        yield path
        for key, inner in value.items():
            yield from objects(inner, path + (key,))
    elif isinstance(value, list):
        for index, inner in enumerate(value[:2]):  # the others are of its kind
            yield from objects(inner, path + (index,))


def at(document, path):
    for step in path:
        document = document[step]
    return document


def of_another_type(value):
    return [] if isinstance(value, str) or value is None else "x"


def mutants(document):
    for path in objects(document):
        for key in at(document, path):
            for kind in ("misspelt", "retyped", "gone"):
                mutant = copy.deepcopy(document)
                inner = at(mutant, path)
                value = inner.pop(key)
                if kind == "misspelt":
                    inner[key + "_"] = value
                elif kind == "retyped":
                    inner[key] = of_another_type(value)
                yield kind, path + (key,), mutant


def main():
    schema = json.load(open(sys.argv[1], encoding="utf-8"))
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    tried = 0
    for line in open(sys.argv[2], encoding="utf-8"):
        document = json.loads(line)
        if "--mutated" not in sys.argv:
            for error in validator.iter_errors(document):
                while error.context:
                    error = max(error.context, key=lambda inner: len(inner.absolute_path))
                print("/".join(map(str, error.absolute_path)), error.message[:300])
            continue
        for kind, path, mutant in mutants(document):
            tried += 1
            if validator.is_valid(mutant):
                print(kind, "/".join(map(str, path)))
    if "--mutated" in sys.argv:
        print(tried)


main()
