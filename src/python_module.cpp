// idiophone._core: the extension of the Python module. It computes in the process of Python, and hands NumPy arrays
// over without files. python/idiophone/native.py is what calls it.

#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <spdlog/details/null_mutex.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/app/body_modes.hpp"
#include "idiophone/app/deck_run.hpp"
#include "idiophone/app/guest.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/study/mode_kinds/mode_kinds.hpp"

namespace {

namespace py = pybind11;
using idiophone::Index;
namespace app = idiophone::app;
namespace mesh = idiophone::mesh;

/// Hands what is logged to a function of Python, with its level (10 debug, 20 information, 30 warning, ...). If that
/// function raises an exception, the computation stops as by a signal.
class PythonSink : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
 public:
  explicit PythonSink(py::function log) : log_(std::move(log)) {}

  /// What the function raised, if it did.
  std::optional<py::error_already_set> failure;

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    const py::gil_scoped_acquire python;
    try {
      log_(10 * static_cast<int>(message.level),
           py::bytes(message.payload.data(), message.payload.size()).attr("decode")("utf-8", "replace"));
    } catch (py::error_already_set& error) {
      if (!failure) {
        failure.emplace(error);
        idiophone::loop::GuestSignals::ask_to_stop();
      }
    }
  }
  void flush_() override {}

 private:
  py::function log_;
};

/// While it lives, what is logged goes to a function of Python.
class PythonLog {
 public:
  explicit PythonLog(py::function log)
      : sink_(std::make_shared<PythonSink>(std::move(log))), before_(spdlog::default_logger()) {
    spdlog::set_default_logger(std::make_shared<spdlog::logger>(name, sink_));
  }
  PythonLog(const PythonLog&) = delete;
  PythonLog& operator=(const PythonLog&) = delete;
  PythonLog(PythonLog&&) = delete;
  PythonLog& operator=(PythonLog&&) = delete;
  ~PythonLog() {
    spdlog::set_default_logger(before_);
    spdlog::drop(name);  // later versions of spdlog would keep it, and with it the function, until Python is gone
  }

  /// Rank 0 speaks for all, as in the program.
  void choose_speaker(MPI_Comm communicator) const {
    sink_->set_level(idiophone::parallel::is_root(communicator) ? spdlog::level::info : spdlog::level::err);
  }

  [[nodiscard]] std::optional<py::error_already_set>& failure() const { return sink_->failure; }

 private:
  static constexpr auto name = "idiophone in Python";
  std::shared_ptr<PythonSink> sink_;
  std::shared_ptr<spdlog::logger> before_;
};

/// Computes while other threads of Python go on.
/// @throws what the function that logs raised; KeyboardInterrupt where Ctrl-C stopped it; as app::compute_as_guest()
void compute(const std::function<MPI_Comm()>& communicator, py::function log,
             const std::function<int(MPI_Comm)>& work) {
  const PythonLog speaker(std::move(log));
  try {
    const py::gil_scoped_release others;
    app::compute_as_guest(communicator, [&](MPI_Comm own) {
      speaker.choose_speaker(own);
      return work(own);
    });
  } catch (const app::StoppedRun& stop) {
    if (speaker.failure()) {
      throw py::error_already_set(*speaker.failure());
    }
    if (stop.signal == SIGINT) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
      throw py::error_already_set();
    }
    throw;
  }
  if (speaker.failure()) {
    throw py::error_already_set(*speaker.failure());
  }
}

/// @param rows  all of one width
template <class Rows>
auto array_of(const Rows& rows, std::vector<py::ssize_t> shape) {
  using Value = std::decay_t<decltype(*std::begin(rows.front()))>;
  py::array_t<Value> array(std::move(shape));
  Value* place = array.mutable_data();
  for (const auto& row : rows) {
    place = std::copy(std::begin(row), std::end(row), place);
  }
  return array;
}

/// Node numbers of the cells that elements are drawn as, in VTK's order. [cells x nodes per cell]
py::array_t<Index> drawn_cells(const mesh::Mesh& body) {
  const auto& cells = idiophone::element::reference(body.element).drawn.cells;
  std::vector<std::vector<Index>> all;
  for (Index e = 0; e < body.element_count(); ++e) {
    const auto nodes = body.element_nodes(e);
    for (const std::vector<int>& cell : cells) {
      auto& own = all.emplace_back();
      std::ranges::transform(cell, std::back_inserter(own), [&](int place) { return nodes[place]; });
    }
  }
  return array_of(all, {static_cast<py::ssize_t>(all.size()), static_cast<py::ssize_t>(cells.front().size())});
}

py::array_t<double> facts_of(const idiophone::eigenmodes::Modes& found, double idiophone::eigenmodes::Mode::*fact) {
  std::vector<double> values;
  for (const auto& mode : found.modes) {
    values.push_back(mode.*fact);
  }
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::dict modes(const std::string& deck, const std::vector<std::string>& settings, const std::string& body, int count,
               std::optional<bool> estimate, py::function log) {
  if (count < 1) {
    throw py::value_error(fmt::format("count must be at least 1, not {}", count));
  }
  using idiophone::eigenmodes::Estimates;
  const Estimates estimates = !estimate ? Estimates::quick : *estimate ? Estimates::all : Estimates::none;
  std::vector<mesh::Mesh> meshes;
  app::BodyModes its;
  std::vector<double> errors;
  std::vector<std::string> kinds;
  compute([] { return MPI_COMM_SELF; }, std::move(log),
          [&](MPI_Comm communicator) {
            using idiophone::eigenmodes::MassMatrix;
            const auto scene = idiophone::bodies::read_deck(deck, settings, communicator);
            idiophone::scene::refuse_joints(scene, "modes() of Python");
            const auto solids = idiophone::scene::Solids(scene).alone(idiophone::scene::find_body(scene.bodies, body));
            meshes = idiophone::bodies::read_meshes(solids, communicator);
            its = app::find_body_modes(solids, meshes, {.count = count}, communicator);
            errors =
                app::estimated_mesh_errors(estimates, MassMatrix::lumped, solids, meshes, its.shapes, communicator);
            kinds = idiophone::mode_kinds::kinds_of(meshes.front().nodes, its.shapes);
            return idiophone::loop::exit_finished;
          });
  using idiophone::eigenmodes::Mode;
  const auto mode_count = static_cast<py::ssize_t>(its.shapes.size());
  const auto node_count = static_cast<py::ssize_t>(meshes.front().nodes.size());
  py::dict found;
  found["frequency"] = facts_of(its.found, &Mode::frequency);
  found["damping_ratio"] = facts_of(its.found, &Mode::damping_ratio);
  found["decay_time"] = facts_of(its.found, &Mode::decay_time);
  found["shape"] = array_of(its.shapes, {mode_count, node_count, 3});
  found["nodes"] = array_of(meshes.front().nodes, {node_count, 3});
  found["elements"] = drawn_cells(meshes.front());
  found["mesh_error"] = errors.empty() ? py::object(py::none()) : py::array_t<double>(mode_count, errors.data());
  found["rigid_motions"] = its.found.rigid_motions;
  found["kinds"] = kinds;
  return found;
}

/// @throws app::FailedComputation if it belongs to another MPI than ours
MPI_Comm communicator_of(MPI_Fint handle) {
  if (!app::mpi_runs()) {
    throw app::FailedComputation(
        "the communicator belongs to an MPI that is not that of idiophone: mpi4py has to be built for the same one "
        "(Debian's python3-mpi4py is)");
  }
  return MPI_Comm_f2c(handle);
}

void run(const std::string& deck, const std::vector<std::string>& settings, const std::string& output_folder,
         bool resume, MPI_Fint communicator, py::function log) {
  const MPI_Comm ours = communicator_of(communicator);
  compute([=] { return ours; }, std::move(log),
          [&](MPI_Comm own) {
            return app::run_deck({.deck = deck,
                                  .overrides = settings,
                                  .output = output_folder,
                                  .resume = resume,
                                  .scene = {},
                                  .progress = idiophone::loop::ProgressWish::log},
                                 own);
          });
}

}  // namespace

PYBIND11_MODULE(_core, extension) {
  extension.doc() = "Computations of idiophone in this process";
  py::register_exception<app::WrongDeck>(extension, "WrongDeck");
  py::register_exception<app::FailedComputation>(extension, "FailedComputation");
  py::register_exception<app::StoppedRun>(extension, "StoppedRun");
  extension.def("modes", &modes, py::arg("deck"), py::arg("settings"), py::arg("body"), py::arg("count"),
                py::arg("estimate"), py::arg("log"),
                "The lowest modes of a body, by the names of the fields of Modes.");
  extension.def("run", &run, py::arg("deck"), py::arg("settings"), py::arg("output_folder"), py::arg("resume"),
                py::arg("communicator"), py::arg("log"),
                "Runs a deck on the ranks of a communicator, a Fortran handle.");
  extension.def("end", &app::end_guest, "Ends PETSc, and MPI if this module has started it.");
}
