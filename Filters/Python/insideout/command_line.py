# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `insideout`, which is `python3 -m insideout`, too.

Names, endings, folders and parameters are checked before the work begins. Files are written before anything is printed
about them. Several surfaces are processed one after the other; one that fails does not stop the others.
"""

from __future__ import annotations

import argparse
from typing import Optional, Sequence

from .arguments import USAGE_ERROR, Files, parse
from .calling import quietly
from .commands.boolean import BooleanJob
from .commands.check import CheckJob, SolidCheckJob
from .commands.demo import run_demo
from .commands.draw import DefectsJob, DrawJob
from .commands.dry_run import DryRun
from .commands.job import SUCCESS, Job, print_error, print_lines
from .commands.mesh import MeshJob
from .commands.query import QueryJob
from .commands.refine import RefineJob
from .commands.repair import RepairJob
from .files import identity
from .pipeline import Error, set_threads
from .summary import table

JOBS: dict[str, type[Job]] = {
    "mesh": MeshJob,
    "repair": RepairJob,
    "check": CheckJob,
    "refine": RefineJob,
    "boolean": BooleanJob,
    "query": QueryJob,
    "draw": DrawJob,
}


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run the command. Returns the exit status: 0 if every surface succeeded, 1 if one failed, 2 for invalid
    arguments."""
    with quietly():  # each job prints its warnings
        return _main(arguments)


def _main(arguments: Optional[Sequence[str]]) -> int:
    options, all_files = parse(arguments)
    if options.command == "demo":
        return run_demo(options.folder, options.quiet)
    try:
        check_names(options, all_files)
    except Error as error:
        print_error(str(error))
        return USAGE_ERROR
    if options.threads is not None:
        set_threads(options.threads)
    jobs = []
    for files in all_files:
        jobs.append(job_of(options, files))
        if jobs[-1].run() > USAGE_ERROR:
            break  # interrupted
    if len(all_files) > 1 and not (options.quiet or options.json):
        rows = [(job.files.name(), {"SecondsTotal": job.seconds, **job.statistics}, job.result()) for job in jobs]
        print_lines(table(rows, sum(job.status == SUCCESS for job in jobs), len(all_files)))
    return max(job.status for job in jobs)


def job_of(options: argparse.Namespace, files: Files) -> Job:
    """The job for the files of one surface, or of one solid."""
    job = JOBS[options.command]
    if options.command in ("check", "draw") and files.is_solid():
        job = SolidCheckJob
    elif options.defects:
        job = DefectsJob
    return DryRun(job(options, files)) if options.dry_run else job(options, files)


def check_names(options: argparse.Namespace, all_files: Sequence[Files]) -> None:
    """Raise `Error` if a file would be both read and written, or written twice, even under different names."""
    read = [*(surface for files in all_files for surface in files.surfaces()), options.points, getattr(options, "seeds", None)]
    inputs = {identity(path): path for path in read if path not in (None, "-")}
    outputs: dict[object, str] = {}
    for path in (path for files in all_files for path in files.outputs()):
        which = identity(path)
        if which is not None and which in inputs:
            raise Error(f"{path} is named twice: it is read as {inputs[which]}, and no output may replace it")
        if which is not None and which in outputs:
            raise Error(f"{path} is named twice: it is {outputs[which]}, and a file cannot be two things")
        outputs[which] = path
