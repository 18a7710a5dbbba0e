#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>

namespace scatter::test {

/// Does to the only window of the display what a user would do.
class X11User {
 public:
  /// The window is open.
  X11User();
  X11User(const X11User&) = delete;
  X11User& operator=(const X11User&) = delete;
  ~X11User();

  /// Keys by their X11 names.
  void press(const std::string& key) { type(key, true); }
  void release(const std::string& key) { type(key, false); }

  void move(const glm::ivec2& pixel);

  /// 1 left, 2 middle, 3 right, 4 and 5 the wheel away from and toward the user.
  void button(unsigned number, bool down);

  void resize(const glm::ivec2& size);

  /// What the window's frame says.
  [[nodiscard]] std::string title() const;
  void close();

 private:
  struct Connection;

  void type(const std::string& key, bool down);

  std::unique_ptr<Connection> connection_;
};

}  // namespace scatter::test
