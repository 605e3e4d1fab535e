# tests/mpi.sh, sourced after tell.sh and small.sh: the program that runs by MPI, in $tmp/randpack, and `ranks K WORD...`.
command -v mpirun > "$tmp/found" && command -v mpicc > "$tmp/found" || { echo 'SKIP: mpirun and mpicc are not installed, so nothing was run by MPI'; exit; }
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl_base_warn_component_unused=0
others=$(ls build/obj/*.o | grep -vE '/(ranks|ref_.*)\.o$')
# shellcheck disable=SC2046,SC2086
${CC:-gcc} -O2 -std=c11 -D_POSIX_C_SOURCE=200809L -fopenmp -DRANDPACK_MPI $(mpicc --showme:compile) -Ibuild/c build/plain/ranks.c $others \
  -lconfig -lfftw3 -lz -lgsl -lgslcblas -lm $(mpicc --showme:link) -o "$tmp/randpack" || exit 1
ranks() { # ranks K WORD...: by so many ranks
  local k=$1
  shift
  mpirun --oversubscribe -n "$k" "$tmp/randpack" "$@"
}
# Six realizations, each of which takes a second or two.
printf '%s\n' 'dimension = 3; seed = 8; realizations = 6; save = true; species = ( { name = "A"; radius = 1.0; number = 1500; } ); fraction = 0.6;
make = { method = "crm"; growth = 0.01; }; measure = { contact = {}; };' > "$tmp/long.scene"
