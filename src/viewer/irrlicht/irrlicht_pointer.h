#pragma once

#include <memory>

namespace scatter::viewer {

/// Gives an Irrlicht object back.
struct IrrlichtDrop {
  template <class T>
  void operator()(T* object) const {
    object->drop();
  }
};

/// Owns one reference to an Irrlicht object.
template <class T>
using IrrlichtPointer = std::unique_ptr<T, IrrlichtDrop>;

}  // namespace scatter::viewer
