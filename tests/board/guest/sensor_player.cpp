// Sensors of a 3-DOF rig on a CAN bus: 16-bit sensor frames at 1 kHz, as regular as the kernel's timer. Real sensors do
// not share the board's processor: it runs before everything that is not as urgent as the controller itself. usage:
// sensor_player INTERFACE SECONDS
#include <sched.h>
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "firmware/can_protocol/streams/sensor_frames.hpp"
#include "hal/linux/can/socket_can.hpp"

namespace {

constexpr long kPeriod_ns = 1000000;

// A triangle of the given period: the values do not matter, their arrival does.
int32_t triangle(uint32_t sequence, uint32_t period, int32_t height) {
  const auto place = static_cast<int32_t>(sequence % period), half = static_cast<int32_t>(period / 2);
  return (place < half ? place : static_cast<int32_t>(period) - place) * height / half - height / 2;
}

firmware::CoreConfiguration channels_of_three_dofs() {
  firmware::CoreConfiguration configuration;
  configuration.dof_count = 3;
  for (int dof = 0; dof < 3; ++dof)
    for (int quantity = dof == 0 ? 0 : 1; quantity < firmware::kQuantities; ++quantity)
      configuration.channels[dof][quantity].present = true;
  return configuration;
}

bool send(hal::SocketCan& bus, const firmware::CanFrame& message) {
  hal::CanFrame frame;
  frame.id = message.id;
  frame.length = message.length;
  std::memcpy(frame.data, message.data, sizeof frame.data);
  return bus.send(frame) == hal::CanResult::kDone;
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  sched_param urgent{};
  urgent.sched_priority = 70;
  if (::sched_setscheduler(0, SCHED_FIFO, &urgent) != 0) return 1;
  hal::SocketCan bus;
  const std::string fault = bus.open(words[1], {});
  if (!fault.empty()) {
    std::fprintf(stderr, "sensor_player: %s\n", fault.c_str());
    return 1;
  }
  const firmware::SensorPlan plan = firmware::sensor_plan(channels_of_three_dofs(), firmware::SensorWiring::k16);
  const uint32_t samples = 1000 * static_cast<uint32_t>(std::atoi(words[2]));
  uint32_t refused = 0;
  timespec due{};
  clock_gettime(CLOCK_MONOTONIC, &due);
  for (firmware::RawSample sample; sample.sequence < samples; ++sample.sequence) {
    for (int dof = 0; dof < 3; ++dof)
      for (uint32_t quantity = 0; quantity < 4; ++quantity)
        sample.code[dof][quantity] =
            triangle(sample.sequence, 40 + 14 * quantity + 6 * static_cast<uint32_t>(dof), 20000);
    firmware::CanFrame messages[firmware::kMaxSensorFrames];
    const int frames = firmware::pack_sample(plan, sample, messages);
    for (int i = 0; i < frames; ++i) refused += send(bus, messages[i]) ? 0 : 1;
    due.tv_nsec += kPeriod_ns;
    if (due.tv_nsec >= 1000000000) {
      due.tv_nsec -= 1000000000;
      ++due.tv_sec;
    }
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
  }
  std::printf("sensor_player: %u samples, %u frames refused\n", samples, refused);
  return refused == 0 ? 0 : 1;
}
