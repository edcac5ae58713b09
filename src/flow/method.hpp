#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/keys.hpp"
#include "flow/case.hpp"
#include "flow/solver.hpp"
#include "flow/warnings.hpp"

namespace vortree::flow {

/// A method that a scene can name: the tables that it brings to scenes, what it makes of them, and
/// the Solver that it begins with. It holds the settings of one scene.
class Method {
 public:
  virtual ~Method() = default;
  virtual std::unique_ptr<Method> clone() const = 0;  ///< with these settings
  virtual std::unique_ptr<Method> blank() const = 0;  ///< as no scene has yet set it

  virtual std::string_view name() const = 0;

  /// Its own tables, whose names no other has.
  virtual std::vector<SceneTable> tables() { return {}; }

  /// Fills in what is not written: its own keys, and of the case the step and the panels.
  /// throws  Refused if something is neither written nor chosen
  virtual void choose(Case& /*of*/, const Written& /*written*/) {}

  /// throws  Refused for what cannot be meant, or computed
  virtual void refuse(const Case& /*of*/) const {}

  /// throws  Refused, with the numbers, for a scene that needs more memory than there is [bytes]
  virtual void refuse_beyond(const Case& /*of*/, double /*memory*/) const {}

  /// What will go wrong with a scene that is valid but asks for too much, a sentence each.
  virtual Warnings warnings(const Case& /*of*/) const { return {}; }

  /// memory  of the machine, which bounds the number of particles [bytes]
  virtual std::unique_ptr<Solver> begin(const Case& of, double memory) const = 0;
};

/// A method as a value: a copy has settings of its own.
class AnyMethod {
 public:
  explicit AnyMethod(std::unique_ptr<Method> method) : method_(std::move(method)) {}
  AnyMethod(const AnyMethod& other) : method_(other.method_->clone()) {}
  AnyMethod(AnyMethod&&) = default;
  AnyMethod& operator=(AnyMethod other) {
    method_ = std::move(other.method_);
    return *this;
  }

  Method* operator->() { return method_.get(); }
  const Method* operator->() const { return method_.get(); }
  const Method& operator*() const { return *method_; }

 private:
  std::unique_ptr<Method> method_;
};

/// Those that a scene can choose among; the first is what a scene gets that names none.
using Methods = std::vector<AnyMethod>;

}  // namespace vortree::flow
