#!/bin/sh
# slurm_task.sh LIST COMMAND...: a task of the array. A task that lost its node, or had to make room, is put back into the queue
# and goes on from the run's checkpoint. The environment (SBATCH_MEM_PER_NODE ...) overrides what stands here.
#SBATCH --job-name=ifedem
#SBATCH --requeue
#SBATCH --ntasks=1
#SBATCH --mem=500M
#SBATCH --open-mode=append
file=$(sed -n "${SLURM_ARRAY_TASK_ID}p" "$1")
shift
exec "$@" "$file"
