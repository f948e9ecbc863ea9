// Every transition of docs/controller.md's table of states, with outputs that refuse and a bus that does not take frames.
#include "firmware/rig_controller/safety/safe_state.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "hal/fake/fake_can_bus.hpp"
#include "hal/fake/fake_devices.hpp"

namespace {

using firmware::AlarmCause;
using firmware::Drive;
using firmware::SafeState;
using State = SafeState::State;

constexpr uint64_t kMillisecond_ns = 1000000;

// One step of what the controller does around the state, without the controller.
struct Rig {
  explicit Rig(bool on_can) { link.configure(1, on_can, Drive::from_raw(INT32_MAX)); }

  void begin() {
    clock.advance_ns(kMillisecond_ns);
    safe.begin_step(clock.now_ns());
    safe.look_at_line();
    if (safe.state() == State::kStopping) safe.make_safe();
  }
  void end() {
    queue.flush(can);
    safe.check_delivery();
  }
  void step() {
    begin();
    end();
  }
  void refuse(bool refuses) {
    drive.refuse(refuses);
    relay.refuse(refuses);
  }
  // The bus does not take frames (and there is one to take: only with the drive on CAN).
  void block(bool blocked) { can.fail(blocked ? hal::BusFailure::kQueueFull : hal::BusFailure::kNone); }
  bool dead() const { return drive.drive_q31() == 0 && !relay.active(); }

  hal::ManualClock clock;
  hal::FakeCanBus can{clock};
  hal::FakeDrive drive;
  hal::FakeOutput relay;
  hal::FakeInput line;
  firmware::TransmitQueue queue;
  firmware::DriveLink link{drive, queue};
  SafeState safe{line, relay, link};
};

void boot(Rig& rig) {
  rig.begin();
  rig.safe.make_safe();
  rig.end();
}

void drive(Rig& rig) {
  rig.begin();
  rig.safe.energise();
  rig.safe.command(Drive::from_raw(1 << 20), 0);
  rig.end();
}

void trip(Rig& rig) {
  rig.begin();
  rig.safe.stop({AlarmCause::kSensorLost});
  rig.end();
}

// Ways into a state.
void into_unknown(Rig&) {}
void into_safe(Rig& rig) { boot(rig); }
void into_live(Rig& rig) {
  boot(rig);
  drive(rig);
}
void into_stopping(Rig& rig) {
  into_live(rig);
  rig.refuse(true);
  trip(rig);
}
void into_stopped(Rig& rig) {
  into_live(rig);
  trip(rig);
}

struct Transition {
  std::string name;
  State from;
  std::function<void(Rig&)> way, event;
  State to;
};

void in_a_step(Rig& rig, const std::function<void(Rig&)>& event) {
  rig.begin();
  event(rig);
  rig.end();
}

void press(Rig& rig) { rig.line.set(true, 0); }

std::vector<Transition> transitions() {
  const auto step = [](Rig& rig) { rig.step(); };
  const auto pressed = [](Rig& rig) {
    press(rig);
    rig.step();
  };
  const auto stop = [](Rig& rig) { trip(rig); };
  const auto stop_refused = [](Rig& rig) {
    rig.refuse(true);
    trip(rig);
  };
  const auto energise = [](Rig& rig) { in_a_step(rig, [](Rig& r) { r.safe.energise(); }); };
  const auto energise_refused = [](Rig& rig) {
    rig.relay.refuse(true);
    in_a_step(rig, [](Rig& r) { r.safe.energise(); });
  };
  const auto command_refused = [](Rig& rig) {
    rig.drive.refuse(true);
    in_a_step(rig, [](Rig& r) { r.safe.command(Drive::from_raw(5), 1); });
  };
  const auto end = [](Rig& rig) {
    in_a_step(rig, [](Rig& r) {
      r.safe.command(Drive{}, 1);
      r.safe.end();
    });
  };
  const auto end_refused = [](Rig& rig) {
    rig.relay.refuse(true);
    in_a_step(rig, [](Rig& r) { r.safe.end(); });
  };
  const auto end_with_drive_on = [](Rig& rig) { in_a_step(rig, [](Rig& r) { r.safe.end(); }); };
  const auto reset = [](Rig& rig) { in_a_step(rig, [](Rig& r) { r.safe.reset(); }); };
  const auto reset_pressed = [](Rig& rig) {
    press(rig);
    in_a_step(rig, [](Rig& r) { EXPECT_FALSE(r.safe.reset()); });
  };
  const auto heal = [](Rig& rig) {
    rig.refuse(false);
    rig.step();
  };
  const auto command = [](Rig& rig) { in_a_step(rig, [](Rig& r) { r.safe.command(Drive::from_raw(5), 1); }); };
  return {
      {"start of the program", State::kUnknown, into_unknown, boot, State::kSafe},
      {"start, an output refuses", State::kUnknown, into_unknown,
       [](Rig& rig) {
         rig.refuse(true);
         boot(rig);
       },
       State::kStopping},
      {"pressed at the start", State::kUnknown, into_unknown, pressed, State::kStopped},
      {"start and reset do nothing yet", State::kUnknown, into_unknown,
       [&](Rig& rig) {
         in_a_step(rig, [](Rig& r) {
           r.safe.energise();
           EXPECT_FALSE(r.safe.reset());
         });
       },
       State::kUnknown},
      {"START", State::kSafe, into_safe, energise, State::kLive},
      {"START, the relay refuses", State::kSafe, into_safe, energise_refused, State::kStopping},
      {"commands do nothing", State::kSafe, into_safe, command, State::kSafe},
      {"pressed", State::kSafe, into_safe, pressed, State::kStopped},
      {"a reason to stop", State::kSafe, into_safe, stop, State::kStopped},
      {"RESET", State::kSafe, into_safe, reset, State::kSafe},
      {"commands", State::kLive, into_live, command, State::kLive},
      {"RESET while driven", State::kLive, into_live, reset, State::kLive},
      {"pressed", State::kLive, into_live, pressed, State::kStopped},
      {"a reason to stop", State::kLive, into_live, stop, State::kStopped},
      {"a reason to stop, an output refuses", State::kLive, into_live, stop_refused, State::kStopping},
      {"the converter refuses", State::kLive, into_live, command_refused, State::kStopping},
      {"programme done", State::kLive, into_live, end, State::kSafe},
      {"programme done, the relay refuses", State::kLive, into_live, end_refused, State::kStopping},
      {"programme done with the drive on", State::kLive, into_live,
       [&](Rig& rig) {
         end_with_drive_on(rig);
         EXPECT_TRUE(rig.dead());
       },
       State::kSafe},
      {"still refused", State::kStopping, into_stopping, step, State::kStopping},
      {"RESET while refused", State::kStopping, into_stopping, reset, State::kStopping},
      {"START while refused", State::kStopping, into_stopping, energise, State::kStopping},
      {"pressed while refused", State::kStopping, into_stopping, pressed, State::kStopping},
      {"delivered", State::kStopping, into_stopping, heal, State::kStopped},
      {"START", State::kStopped, into_stopped, energise, State::kStopped},
      {"commands", State::kStopped, into_stopped, command, State::kStopped},
      {"pressed", State::kStopped, into_stopped, pressed, State::kStopped},
      {"RESET, pressed", State::kStopped, into_stopped, reset_pressed, State::kStopped},
      {"RESET", State::kStopped, into_stopped, reset, State::kSafe},
      {"another reason", State::kStopped, into_stopped, stop, State::kStopped},
      {"another reason, an output refuses", State::kStopped, into_stopped, stop_refused, State::kStopping},
  };
}

TEST(SafeState, EveryTransition) {
  for (const bool on_can : {false, true}) {
    for (const Transition& transition : transitions()) {
      SCOPED_TRACE(transition.name + (on_can ? ", drive on CAN" : "") + ", from " +
                   std::to_string(static_cast<int>(transition.from)));
      Rig rig(on_can);
      transition.way(rig);
      ASSERT_EQ(rig.safe.state(), transition.from);
      transition.event(rig);
      EXPECT_EQ(rig.safe.state(), transition.to);
      // What a state says of the outputs is so.
      if (rig.safe.state() == State::kSafe || rig.safe.state() == State::kStopped) {
        EXPECT_TRUE(rig.dead());
      }
      EXPECT_EQ(rig.safe.state() == State::kStopped, rig.safe.tripped() && rig.safe.state() != State::kStopping);
      EXPECT_EQ(rig.safe.live(), rig.safe.state() == State::kLive);
      EXPECT_EQ(rig.safe.output_refuses(), rig.safe.state() == State::kStopping);
    }
  }
}

TEST(SafeState, TheFirstReasonStaysAndAnEmergencyStopTakesItsPlace) {
  Rig rig(false);
  into_live(rig);
  trip(rig);
  in_a_step(rig, [](Rig& r) { r.safe.stop({AlarmCause::kSensorFault}); });
  EXPECT_EQ(rig.safe.latched().cause, AlarmCause::kSensorLost);
  press(rig);
  rig.step();
  EXPECT_EQ(rig.safe.latched().cause, AlarmCause::kEmergencyStop);
  EXPECT_EQ(rig.safe.trips(), 3u);
}

// Outputs that refuse one time in so many, at any attempt: sooner or later both are safe, and never said to be before.
TEST(SafeState, SafeIsSaidOnlyOfWhatWasDelivered) {
  for (int refusals_of_drive = 0; refusals_of_drive < 4; ++refusals_of_drive) {
    for (int refusals_of_relay = 0; refusals_of_relay < 4; ++refusals_of_relay) {
      Rig rig(false);
      into_live(rig);
      const int needed = std::max(refusals_of_drive, refusals_of_relay);
      rig.drive.refuse_next(refusals_of_drive);
      rig.relay.refuse_next(refusals_of_relay);
      trip(rig);
      for (int i = 0; i <= needed; ++i) {
        EXPECT_EQ(rig.safe.state() == State::kStopped, i == needed);
        EXPECT_EQ(rig.dead(), i == needed);
        EXPECT_EQ(rig.safe.output_refuses(), i < needed);
        rig.step();
      }
    }
  }
}

// The amplifier is at the other end of the bus: zero is delivered when the bus has taken it.
TEST(SafeState, WithTheDriveOnCanADeadBusIsNotSafe) {
  for (const hal::BusFailure failure :
       {hal::BusFailure::kQueueFull, hal::BusFailure::kDown, hal::BusFailure::kDriverFault}) {
    Rig rig(true);
    into_live(rig);
    rig.can.fail(failure);
    trip(rig);
    for (int i = 0; i < 50; ++i) {
      EXPECT_EQ(rig.safe.state(), State::kStopping);
      EXPECT_FALSE(rig.safe.output_refuses());  // a restart of the board would not help: the watchdog is fed
      EXPECT_FALSE(rig.safe.reset());
      rig.step();
    }
    EXPECT_TRUE(rig.dead());  // what this board can do it has done
    rig.can.fail(hal::BusFailure::kNone);
    rig.step();
    EXPECT_EQ(rig.safe.state(), State::kStopped);
    const hal::CanFrame& last = *rig.can.last(0x201);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(last.data[i], 0);
    EXPECT_EQ(last.data[6], 2);  // STOPPED
  }
}

// A converter on a hanging bus may not come back for a second: the relay does not wait for it.
TEST(SafeState, TheRelayOpensBeforeTheConverterIsAsked) {
  struct Converter final : hal::DriveOutput {
    explicit Converter(const hal::FakeOutput& relay) : relay_(relay) {}
    bool write(int32_t drive_q31) override {
      closed_at_zero_ = closed_at_zero_ || (drive_q31 == 0 && relay_.active());
      return true;
    }
    const hal::FakeOutput& relay_;
    bool closed_at_zero_ = false;
  };
  hal::FakeOutput relay;
  hal::FakeInput line;
  Converter converter(relay);
  firmware::TransmitQueue queue;
  firmware::DriveLink link{converter, queue};
  link.configure(1, false, Drive::from_raw(INT32_MAX));
  SafeState safe{line, relay, link};
  safe.begin_step(kMillisecond_ns);
  safe.make_safe();
  ASSERT_FALSE(safe.energise());
  ASSERT_TRUE(relay.active());
  ASSERT_FALSE(safe.command(Drive::from_raw(1 << 20), 1));
  line.set(true, 0);
  safe.begin_step(2 * kMillisecond_ns);
  EXPECT_EQ(safe.look_at_line().cause, AlarmCause::kEmergencyStop);
  EXPECT_FALSE(relay.active());
  EXPECT_FALSE(converter.closed_at_zero_);
}

}  // namespace
