#!/usr/bin/env bash
# A class by many machines: a real Slurm of two nodes, of which one dies in the midst of it; and GNU parallel with hosts, of
# which one is down. The grades are byte for byte those of one machine.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
class=$work/class three=03-shadow-map
chmod 711 "$work"
mkdir -m 711 "$work/tmp" && export TMPDIR=$work/tmp # what is killed leaves its files there
for name in one two "three 3" four five six; do
    mkdir -p "$class/$name" && cp -r "solutions/$three" "$class/$name"
    echo "// $name" >>"$class/$name/$three/lab.c"
done
sed -i 's/GL_NEAREST/GL_LINEAR/' "$class/two/$three/lab.c"
rm -rf "${class:?}/six/$three" && cp -r "labs/$three" "$class/six"
options=(--class "$class" --lab 03 --seed 9)
grades "${options[@]}" --output "$work/alone"
expect "one machine" 0 "6 submissions, 0 not graded"
cluster() { # OUT BY: by a batch of one name, in the few variables that a service has
    status=0
    out=$(env -u SHELL -u HOME BATCH=1 PAUSE=0.3 timeout 100 grader/scripts/cluster "$2" "${options[@]}" --output "$1" 2>&1) || status=$?
}
same() { # NAME OUT
    expect "$1" 0 "6 submissions, 0 not graded"
    cmp -s "$work/alone/grades.csv" "$2/grades.csv" && ok || bad "$1: other grades" "$(diff "$work/alone/grades.csv" "$2/grades.csv")"
    [[ -z $(compgen -G "$2/cluster-*") ]] && ok || bad "$1: something is left" "$(ls "$2")"
}

has_all() { for tool in "$@"; do command -v "$tool" >/dev/null || return 1; done; }
if parallel --version 2>/dev/null | grep -q 'GNU parallel'; then
    cat >"$work/ssh" <<'SSH'
#!/usr/bin/env bash
while [[ $1 == -* ]]; do if [[ $1 == -o || $1 == -l ]]; then shift; fi; shift; done
echo "$1" >>"$(dirname "$0")/asked"
if [[ $1 == down ]]; then exit 255; fi
shift
if [[ $1 == -- ]]; then shift; fi
SHELL=/bin/bash exec bash -c "$*" # as sshd does
SSH
    chmod +x "$work/ssh"
    printf '1/%s\n' alpha down beta >"$work/hosts"
    export PARALLEL_SSH=$work/ssh
    cluster "$work/by hosts" "$work/hosts"
    same "GNU parallel" "$work/by hosts"
    [[ $(sort -u "$work/asked" | xargs) == "alpha beta down" ]] && ok || bad "each host is asked" "$(sort "$work/asked" | uniq -c)"
    touch "$work/by hosts/results"/*
    cluster "$work/by hosts" "$work/hosts"
    expect "what is graded stays" 0 "0 submissions to grade"
else
    skip "hosts: there is no GNU parallel (common/setup --test)"
fi

# Slurm without systemd, on the loopback, its files in one folder.
if ! has_all munged slurmctld slurmd sbatch squeue sinfo; then
    skip "Slurm: there is no slurmctld or munged (common/setup --test)"
    finish
    exit
fi
slurm=$work/slurm base=$((20000 + $$ % 20000)) pids=()
mkdir -p "$slurm"/{n1,n2,state}
chmod 755 "$slurm"
head -c 1024 /dev/urandom >"$slurm/key" && chmod 400 "$slurm/key"
export SLURM_CONF=$slurm/slurm.conf
# The daemons listen where the machine's name leads: 127.0.1.1 as Debian installs it.
address=$(getent ahostsv4 "$(hostname -s)" | awk '{ print $1; exit }')
: "${address:=127.0.0.1}"
# On the node that is to die, a task lasts longer than it takes to see it.
printf '#!/bin/sh\nif [ "$SLURMD_NODENAME" = n1 ]; then sleep 3; fi\n' >"$slurm/prolog" && chmod 755 "$slurm/prolog"
cat >"$SLURM_CONF" <<CONF
ClusterName=lab
SlurmctldHost=$(hostname -s)($address)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
SlurmctldPort=$base
AuthType=auth/munge
AuthInfo=socket=$slurm/socket
CredType=cred/munge
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=sched_interval=1
SlurmdTimeout=5
KillWait=2
TaskProlog=$slurm/prolog
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/%n
SlurmctldPidFile=$slurm/ctld.pid
SlurmdPidFile=$slurm/%n.pid
SlurmctldLogFile=$slurm/ctld.log
SlurmdLogFile=$slurm/%n.log
NodeName=n1 NodeHostname=$(hostname -s) NodeAddr=$address Port=$((base + 1)) CPUs=1
NodeName=n2 NodeHostname=$(hostname -s) NodeAddr=$address Port=$((base + 2)) CPUs=1
PartitionName=p Nodes=n1,n2 Default=YES State=UP
CONF
# Newer ones want control groups, which a service or a container need not have.
slurm_major=$(slurmd -V | sed -nE 's/.* ([0-9]+)\..*/\1/p')
((${slurm_major:-0} < 24)) || echo "CgroupPlugin=disabled" >"$slurm/cgroup.conf"
starts() { "$@" >>"$slurm/said" 2>&1 & pids+=($!); }
# What runs as a task of the node, and who started it there.
of_node() {
    for pid in $(tasks_of "$1"); do
        echo "$pid"
        grep -qs '^slurmstepd' "/proc/$(ps -o ppid= -p "$pid" | tr -d ' ')/comm" && ps -o ppid= -p "$pid"
    done
}
tasks_of() { grep -lz "^SLURMD_NODENAME=$1$" /proc/[0-9]*/environ 2>/dev/null | xargs -r grep -lzF "SLURM_CONF=$SLURM_CONF" 2>/dev/null | cut -d/ -f3; }
stop_all() {
    kill -KILL $(of_node n1) $(of_node n2) "${pids[@]}" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$work"
}
trap stop_all EXIT
starts munged -F --force --key-file="$slurm/key" --socket="$slurm/socket" --pid-file="$slurm/munge.pid" --log-file="$slurm/munge.log" \
    --seed-file="$slurm/seed"
for ((i = 0; i < 50; i++)); do [[ -S $slurm/socket ]] && break || sleep 0.1; done
starts slurmctld -D -c
for node in n1 n2; do starts slurmd -D -N $node; done
for ((i = 0; i < 150; i++)); do [[ $(sinfo -h -N -o %T 2>/dev/null | sort -u) == idle ]] && break || sleep 0.1; done
[[ $(sinfo -h -N -o %T 2>&1 | sort -u) == idle ]] && ok || bad "Slurm does not start" "$(sinfo 2>&1; tail -5 "$slurm"/*.log)"

# The first node dies, with all that runs there, as soon as it has a task.
(
    for ((i = 0; i < 300; i++)); do
        [[ -n $(of_node n1) ]] && break
        sleep 0.1
    done
    echo "$i" >"$slurm/died"
    kill -KILL "${pids[2]}" $(of_node n1)
) &
cluster "$work/by slurm" slurm
same "Slurm" "$work/by slurm"
[[ $(cat "$slurm/died") -lt 300 ]] && ok || bad "no task ever ran on the node that was to die" "$(tail -5 "$slurm"/*.log)"
grep -q ' 1 submissions to grade' <<<"$out" && ok || bad "what the dead node left was not started again" "$out"
finish
