// Put before MPI by LD_PRELOAD: counts the collective calls inside audio blocks, that is, between MPI_Pcontrol(1) and
// MPI_Pcontrol(0), and outside them, and tells at the end. PETSc's and HDF5's calls count as well.
// MPI_Iallgatherv does not: the visibility's positions travel by it, and are waited for at the next look only.

#include <mpi.h>

#include <cstdio>

namespace {

int inside = 0;
int blocks = 0;
long calls_inside = 0;
long calls_outside = 0;

void count() {
  ++(inside != 0 ? calls_inside : calls_outside);
}

}  // namespace

// COUNTED(name, (parameters), (arguments)): the function MPI_name, which counts and hands on to PMPI_name.
#define COUNTED(name, parameters, arguments) \
  extern "C" int MPI_##name parameters {     \
    count();                                 \
    return PMPI_##name arguments;            \
  }

extern "C" int MPI_Pcontrol(const int level, ...) {
  inside = level;
  blocks += level;
  return MPI_SUCCESS;
}

extern "C" int MPI_Finalize() {
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::printf("rank %d: %d blocks, %ld collective calls inside, %ld outside\n", rank, blocks, calls_inside,
              calls_outside);
  std::fflush(stdout);
  return PMPI_Finalize();
}

using Data = const void*;
using Counts = const int*;
using Types = const MPI_Datatype*;

COUNTED(Barrier, (MPI_Comm comm), (comm))
COUNTED(Ibarrier, (MPI_Comm comm, MPI_Request* request), (comm, request))
COUNTED(Bcast, (void* data, int n, MPI_Datatype type, int root, MPI_Comm comm), (data, n, type, root, comm))
COUNTED(Ibcast, (void* data, int n, MPI_Datatype type, int root, MPI_Comm comm, MPI_Request* request),
        (data, n, type, root, comm, request))
COUNTED(Allreduce, (Data from, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
        (from, to, n, type, op, comm))
COUNTED(Iallreduce, (Data from, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm, MPI_Request* request),
        (from, to, n, type, op, comm, request))
COUNTED(Reduce, (Data from, void* to, int n, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm),
        (from, to, n, type, op, root, comm))
COUNTED(Ireduce,
        (Data from, void* to, int n, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm, MPI_Request* request),
        (from, to, n, type, op, root, comm, request))
COUNTED(Scan, (Data from, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm), (from, to, n, type, op, comm))
COUNTED(Iscan, (Data from, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm, MPI_Request* request),
        (from, to, n, type, op, comm, request))
COUNTED(Exscan, (Data from, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
        (from, to, n, type, op, comm))
COUNTED(Reduce_scatter, (Data from, void* to, Counts n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
        (from, to, n, type, op, comm))
COUNTED(Reduce_scatter_block, (Data from, void* to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
        (from, to, n, type, op, comm))
COUNTED(Gather, (Data from, int n, MPI_Datatype type, void* to, int m, MPI_Datatype into, int root, MPI_Comm comm),
        (from, n, type, to, m, into, root, comm))
COUNTED(Gatherv,
        (Data from, int n, MPI_Datatype type, void* to, Counts m, Counts at, MPI_Datatype into, int root,
         MPI_Comm comm),
        (from, n, type, to, m, at, into, root, comm))
COUNTED(Scatter, (Data from, int n, MPI_Datatype type, void* to, int m, MPI_Datatype into, int root, MPI_Comm comm),
        (from, n, type, to, m, into, root, comm))
COUNTED(Scatterv,
        (Data from, Counts n, Counts at, MPI_Datatype type, void* to, int m, MPI_Datatype into, int root,
         MPI_Comm comm),
        (from, n, at, type, to, m, into, root, comm))
COUNTED(Allgather, (Data from, int n, MPI_Datatype type, void* to, int m, MPI_Datatype into, MPI_Comm comm),
        (from, n, type, to, m, into, comm))
COUNTED(Iallgather,
        (Data from, int n, MPI_Datatype type, void* to, int m, MPI_Datatype into, MPI_Comm comm, MPI_Request* request),
        (from, n, type, to, m, into, comm, request))
COUNTED(Allgatherv,
        (Data from, int n, MPI_Datatype type, void* to, Counts m, Counts at, MPI_Datatype into, MPI_Comm comm),
        (from, n, type, to, m, at, into, comm))
COUNTED(Alltoall, (Data from, int n, MPI_Datatype type, void* to, int m, MPI_Datatype into, MPI_Comm comm),
        (from, n, type, to, m, into, comm))
COUNTED(Alltoallv,
        (Data from, Counts n, Counts at, MPI_Datatype type, void* to, Counts m, Counts into_at, MPI_Datatype into,
         MPI_Comm comm),
        (from, n, at, type, to, m, into_at, into, comm))
COUNTED(Alltoallw,
        (Data from, Counts n, Counts at, Types type, void* to, Counts m, Counts into_at, Types into, MPI_Comm comm),
        (from, n, at, type, to, m, into_at, into, comm))
COUNTED(Comm_dup, (MPI_Comm comm, MPI_Comm* copy), (comm, copy))
COUNTED(Comm_split, (MPI_Comm comm, int color, int key, MPI_Comm* part), (comm, color, key, part))
COUNTED(Comm_create, (MPI_Comm comm, MPI_Group group, MPI_Comm* part), (comm, group, part))
