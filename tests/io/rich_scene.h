#pragma once

namespace scatter::test {

/// A file with every section and nearly every key.
inline constexpr const char* kRichScene = R"([scene]
summary = "everything"
frames = 90
seed = 12
gravity = [0, -9.81, 0.5]
solver_iterations = 25
[[material]]
name = "ice"
friction = 0.05
rolling_friction = 0.1
[[field]]
name = "pull"
acceleration = 4
radius = 10
on = false
[[field]]
kind = "uniform"
direction = [2, 0, 0]
acceleration = -3
[[region]]
name = "sky"
kind = "shell"
inner = 2
outer = 5
[[region]]
name = "room"
kind = "box"
size = [4, 5, 6]
clearance = 0.1
[[object]]
name = "hills"
at = [0, -40, 0]
terrain = { size = [30, 20], cells = [6, 4], relief = 2, roughness = 0.3, seed = 5, kind = "height_field" }

[[object]]
name = "floor"
plane = [0, 1, 0]
[[object]]
name = "crate"
model = "crate"
list = [[0, 0, 0], [3, 0, 0]]
group = "things"
gibs = ["mug", "mug"]
[[object]]
name = "ball"
sphere = [0.5, 1]
density = 100
in = "sky"
count = 3
orientation = "random"
velocity = { random = 3 }
spin = { random = 1 }
group = "things"
ignores = ["default"]
[[object]]
name = "brick"
box = [1, 0.5, 0.25]
grid = { count = [3, 2, 2], spacing = [2, 2, 2], center = [0, 5, 0] }
velocity = { toward = [0, 0, 0], speed = 2 }
orientation = { axis = [0, 1, 0], angle = 45 }
material = "ice"
[[object]]
name = "pole"
capsule = { radius = 0.25, length = 2 }
stack = { count = 3, base = [9, 0, 0], gap = 0.1 }
[[object]]
name = "rock"
hull = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
velocity = { away = [0, 0, 0], rate = 0.5 }
in = "room"
[[joint]]
kind = "hinge"
a = "pole-1"
b = "pole-2"
axis = [0, 1, 0]
lower = -90
upper = 90
[[joint]]
kind = "six_dof"
a = "rock"
linear_upper = [0, 2, 0]
[[event]]
do = "throw"
seconds = 0.5
target = ["things", "rock"]
toward = "ball-1"
speed = 7
[[event]]
do = "break"
frame = 30
target = "crate"
burst = 2
[[event]]
do = "knock"
frame = 31
target = "brick-2"
direction = [1, 0, 0]
impulse = 3
body_frame = true
[[event]]
do = "field"
frame = 2
field = "pull"
on = true
)";

}  // namespace scatter::test
