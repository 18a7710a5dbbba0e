#pragma once

#include <scatter/lab/frame_table.h>
#include <scatter/lab/recorder.h>

#include "lab/fake_physics.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace scatter::test {

/// The recorder's columns with the shape of a collision overload: a flight, a peak at 40 % of the frames, a
/// second one, a tail. `cost` scales what it costs in time and manifolds.
inline FrameTable syntheticTable(int frames, double cost, bool hybrid) {
  World world(std::make_unique<FakePhysics>(PhysicsDef{}));
  FrameData data(1);
  const FrameRecorder recorder(world, data);
  FrameTable table(data.channels());
  std::uint32_t random = 12345;
  for (int frame = 1; frame <= frames; ++frame) {
    const double t = static_cast<double>(frame) / frames;
    const auto bump = [t](double at, double width) { return std::exp(-std::pow((t - at) / width, 2.0)); };
    random = random * 1664525U + 1013904223U;
    const double noise = 1.0 + 0.06 * (static_cast<double>(random >> 8U) / 16777216.0 - 0.5);
    const double activity = (bump(0.4, 0.04) + 0.35 * bump(0.55, 0.08) + (t > 0.3 ? 0.12 : 0.0)) * noise;
    const double detail = hybrid && t > 0.38 ? cost : (cost + 1.0) / 2.0;
    data.beginFrame();
    const auto set = [&data](const std::string& name, double value) { data.set(*data.find(name), value); };
    set("frame", frame);
    set("time_s", frame / 60.0);
    double total = 0.0;
    const std::vector<double> shares{0.08, 0.02, 0.62, 0.03, 0.0, 0.2, 0.02, 0.0, 0.01, hybrid ? 0.04 : 0.0};
    for (std::size_t stage = 0; stage < kStageCount; ++stage) {
      const double time = shares[stage] * (0.3 + 30.0 * activity * detail);
      set(std::string(stageColumn(static_cast<Stage>(stage))), time);
      total += time;
    }
    set("physics_ms", total * 1.02 + (frame % 97 == 0 ? 1.5 : 0.0));
    set("physics_cpu_ms", total);
    set("objects", 301);
    set("narrowphase_pairs", std::round(3500.0 * activity));
    set("pairs_with_hybrid", std::round(3000.0 * activity));
    set("pairs_without_hybrid", std::round(500.0 * activity));
    set("manifolds", std::round(17000.0 * activity * detail));
    set("contacts", std::round(9000.0 * activity));
    set("finest_pairs", std::round(3000.0 * activity * (hybrid ? std::max(0.0, 0.5 - t) : 1.0)));
    set("requests", hybrid ? std::round(60.0 * activity) : 0.0);
    set("switches_coarser", hybrid && random % 11U == 0 ? std::round(9.0 * activity) : 0.0);
    set("switches_finer", hybrid && random % 7U == 0 ? std::round(5.0 * bump(0.8, 0.1)) : 0.0);
    table.append(data);
  }
  return table;
}

}  // namespace scatter::test
