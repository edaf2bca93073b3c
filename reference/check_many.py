#!/usr/bin/env python3
"""Checks many certificates in one process: python3 check_many.py < QUESTIONS

A question is a line of file names (certificate, inputs), separated by tabs. The answer is a line: exit code, what check.py
prints first, and its further lines, separated by tabs.
"""
import sys
import check

if __name__ == "__main__":
    for question in sys.stdin:
        status, text = check.run(question.rstrip("\n").split("\t"))
        print(status, *text.replace("\t", " ").split("\n"), sep="\t", flush=True)
