#pragma once
// PETSc's error codes as exceptions, and its objects with an owner.

#include <fmt/format.h>
#include <petscsys.h>

#include <stdexcept>
#include <utility>

namespace idiophone::parallel {

/// @throws std::runtime_error with PETSc's message where a call failed
inline void petsc(PetscErrorCode code) {
  if (code != 0) {
    const char* text = nullptr;
    char* specific = nullptr;
    PetscErrorMessage(code, &text, &specific);
    throw std::runtime_error(fmt::format("PETSc: {} ({})", text != nullptr ? text : "unknown error",
                                         specific != nullptr ? specific : "no details"));
  }
}

/// Owns a PETSc or SLEPc object (Mat, Vec, PetscSF, KSP, SNES, TS, EPS) and destroys it at the end, also when something
/// throws. Passes for the object itself: `Handle<Vec> x; petsc(VecCreate(communicator, x.out())); petsc(VecSet(x, 0));`
template <class Object>
class Handle {
 public:
  Handle() = default;
  explicit Handle(Object object) : object_(object) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Handle() { destroy(); }

  operator Object() const& { return object_; }
  operator Object() const&& = delete;  // a temporary would destroy it at once

  /// Where a creating function puts the object; one that was there is destroyed.
  [[nodiscard]] Object* out() {
    destroy();
    return &object_;
  }

 private:
  void destroy() {
    auto* generic = reinterpret_cast<PetscObject>(object_);  // NOLINT(*-reinterpret-cast): PETSc's way to its base type
    PetscObjectDestroy(&generic);
    object_ = nullptr;
  }

  Object object_ = nullptr;
};

}  // namespace idiophone::parallel
