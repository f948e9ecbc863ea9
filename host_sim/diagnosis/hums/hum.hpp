// Mains hum that the runs leave over.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

constexpr const char* kHumTold = "a hum of";  // how the advice on it begins

// Of what the simulation leaves, or what was taken out before the last fit; per motion channel.
const std::vector<Hum>& hum_seen(const Choice& choice);
// Amplitudes over the channels' rms, 0 below a trifle.
std::vector<double> shares_of_signals(const std::vector<MotionTrace>& traces, const std::vector<Hum>& hum);

// A hum of one motion channel beside others that have none, or far less, is that channel's fault and named; one that all
// channels share is the room's: it is said, and no cause. Where something drives the rig at that frequency a second channel
// of the DOF has to bear it out; of a channel that is alone nobody can tell. What is weighed against the only motion channel are the
// forces. Where a force at its DOF may have it and no other quantity is measured there, that is its rival. hum: per channel.
void name_hum(const Task& task, const std::vector<Hum>& hum, Diagnosis& d);
// That which was taken out before the last fit, or else what it left.
void name_hum(const Task& task, const Choice& choice, Diagnosis& d);

// Hum that two or more channels were named for is the room's too, where it is not far more of one's signal than of any other's; and
// that of one, a force's too, where the simulation leaves as much of it in every motion channel. The only motion channel does not tell
// its own hum from the force's, nor either from that of both: named are they where the hum is louder than the noise.
void say_shared_hum(const Task& task, const Choice& choice, Diagnosis& d);

}  // namespace diagnosis::runs
