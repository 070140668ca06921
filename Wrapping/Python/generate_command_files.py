# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Completion for bash and man page of the command vtkdgg, generated from its parser:
generate_command_files.py COMPLETION PAGE.gz."""

import gzip
import re
import sys

from vtkdgg import build_info
from vtkdgg.command_line import make_parser

COMPLETION = """# Completion of the command vtkdgg.
_vtkdgg() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" words
  case "${{COMP_WORDS[1]}}" in
{cases}
    *) words="{commands} --help --version" ;;
  esac
  if [ "$COMP_CWORD" -eq 1 ] || [[ "$word" == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  fi
}}
complete -o default -F _vtkdgg vtkdgg
"""


def completion(commands):
    """Returns the text of the completion."""
    cases = [
        f'    {name}) words="{" ".join(sorted(parser._option_string_actions))}" ;;'
        for name, parser in commands.items()
    ]
    return COMPLETION.format(cases="\n".join(cases), commands=" ".join(commands))


def plain(text):
    """Returns the text with escaped commands of roff."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^(?=[.'])", "\\&", text, flags=re.M)


def paragraphs(text):
    """Returns filled paragraphs."""
    return [f".PP\n{plain(' '.join(part.split()))}" for part in text.split("\n\n")]


def examples(text):
    """Returns the lines after the first one without filling."""
    return [".PP\n.EX", *(plain(line) for line in text.splitlines()[1:]), ".EE"] if text else []


def section(name, parser):
    """Returns the section of a command: usage, description, arguments."""
    formatter = parser._get_formatter()
    usage = " ".join(parser.format_usage().split()).replace("usage: ", "")
    lines = [f".SS {name}", plain(usage), *paragraphs(parser.description)]
    for action in parser._actions:
        if "--help" not in action.option_strings:
            words = formatter._format_action_invocation(action)
            said = formatter._expand_help(action) if action.help else ""
            lines += [f".TP\n.B {plain(words)}", plain(said) or "\\&"]
    return lines + examples(parser.epilog)


def man_page(parser):
    """Returns the text of the man page."""
    title, *description = parser.description.strip().split("\n\n")
    name = title[0].lower() + title[1:].rstrip(".")
    lines = [
        f'.TH VTKDGG 1 "" "vtkdgg {build_info.VERSION}" "User Commands"',
        f".SH NAME\nvtkdgg \\- {plain(name)}",
        ".SH SYNOPSIS\n.B vtkdgg\n.I command file\n[options]\n.br\n.B vtkdgg \\-\\-version",
        ".SH DESCRIPTION",
        *paragraphs("\n\n".join(description)),
        ".SH COMMANDS",
    ]
    for command, its_parser in parser.commands.items():
        lines += section(command, its_parser)
    lines += [".SH EXAMPLES", *examples(parser.epilog)]
    return "\n".join(lines) + "\n"


def main(completion_path, page_path):
    """Writes both files."""
    parser = make_parser()
    with open(completion_path, "w", encoding="utf-8") as file:
        file.write(completion(parser.commands))
    with open(page_path, "wb") as file:  # without name and time: the same bytes each time
        file.write(gzip.compress(man_page(parser).encode("utf-8"), 9, mtime=0))


if __name__ == "__main__":
    main(*sys.argv[1:])
