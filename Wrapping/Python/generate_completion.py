# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Completion of the command vtkdgg for bash: generate_completion.py FILE."""

import sys

from vtkdgg.command_line import make_parser

SCRIPT = """# Completion of the command vtkdgg.
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


def main(path):
    """Write it."""
    commands = make_parser().commands
    cases = [
        f'    {name}) words="{" ".join(sorted(parser._option_string_actions))}" ;;'
        for name, parser in commands.items()
    ]
    with open(path, "w", encoding="utf-8") as file:
        file.write(SCRIPT.format(cases="\n".join(cases), commands=" ".join(commands)))


if __name__ == "__main__":
    main(sys.argv[1])
