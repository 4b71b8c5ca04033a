#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# sbatch [SBATCH_OPTION ...] scripts/slurm.sh FILE.prm [OPTION ...]
#
# Runs a case as a batch job, in the folder from which it is submitted, with one
# rank for each task. Results go to output/NAME; if a checkpoint is there, the run
# goes on from it. Five minutes before the time is over, SLURM sends SIGTERM: the
# program writes a checkpoint of the last load step and ends with status 143. To go
# on, submit the same line again. The build is that of scripts/run.sh, or the one
# that the environment names: PROGRAM=/path/to/elasto_plastic_contact.
#
#SBATCH --job-name=elasto_plastic_contact
#SBATCH --ntasks=16
#SBATCH --cpus-per-task=1
#SBATCH --time=12:00:00
#SBATCH --signal=TERM@300
#SBATCH --output=%x-%j.log

set -euo pipefail

program=${PROGRAM:-build/release/elasto_plastic_contact}
[ $# -ge 1 ] || {
  echo "slurm.sh: which case? sbatch scripts/slurm.sh FILE.prm [OPTION ...]" >&2
  exit 2
}
[ -x "$program" ] || {
  echo "slurm.sh: there is no program '$program': build it (scripts/run.sh), or name it by PROGRAM=..." >&2
  exit 2
}
case_file=$1
shift

results=output/$(basename "$case_file" .prm)
resume=()
[ ! -d "$results/checkpoint" ] || resume=(--resume)

# One thread per rank. (srun and not mpirun: Open MPI's mpirun kills the ranks one
# second after it has passed SIGTERM on. If srun starts single ranks here, name the
# interface of your MPI: export SLURM_MPI_TYPE=pmix.)
export OMP_NUM_THREADS=1
exec srun "$program" "$case_file" --output-directory "$results" ${resume[@]+"${resume[@]}"} "$@"
