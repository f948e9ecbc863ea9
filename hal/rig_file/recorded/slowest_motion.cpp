#include "hal/rig_file/recorded/slowest_motion.hpp"

#include <algorithm>
#include <cmath>

namespace rig_file {
namespace {

using Record = std::vector<firmware::RawSample>;
using firmware::CoreConfiguration;

constexpr int kX = static_cast<int>(firmware::Quantity::kDisplacement);
constexpr int kV = static_cast<int>(firmware::Quantity::kVelocity);
constexpr int kA = static_cast<int>(firmware::Quantity::kAcceleration);

constexpr double kMostBelow = 0.01;  // friction 0.5 % off at most, as at the top of the band (motion_band.hpp)
// An octave is read in segments of four of its longest periods, half of each in the next: a decay is not lost in a window that is
// long against it. A Hann window leaves nothing of a constant in the second line and beyond.
constexpr int kFirstLine = 4, kLowestLine = 2;

// Which channel tells a node's velocity, the one with the least to do to it; -1: none.
int channel_of_velocity(const CoreConfiguration& configuration, int node) {
  for (const int q : {kV, kA, kX})
    if (configuration.channels[node][q].present) return q;
  return -1;
}

// Mean square of the signal's component at `line` periods in `length` samples, so that all lines of white noise of unit variance sum
// up to one: the mean over segments that half cover each other.
double line_power(const std::vector<double>& signal, size_t length, int line) {
  const double step = 2.0 * M_PI * line / static_cast<double>(length);
  std::vector<double> cosine(length), sine(length);
  double window_power = 0.0;
  for (size_t n = 0; n < length; ++n) {
    const double at = static_cast<double>(n) + 0.5;
    const double window = 0.5 - 0.5 * std::cos(2.0 * M_PI * at / static_cast<double>(length));
    window_power += window * window;
    cosine[n] = window * std::cos(step * at), sine[n] = window * std::sin(step * at);
  }
  double power = 0.0;
  size_t segments = 0;
  for (size_t from = 0; from + length <= signal.size(); from += length / 2, ++segments) {
    double real = 0.0, imaginary = 0.0;
    for (size_t n = 0; n < length; ++n) {
      const double value = signal[from + n] - signal[from];
      real += value * cosine[n], imaginary += value * sine[n];
    }
    power += real * real + imaginary * imaginary;
  }
  return 2.0 * power / (window_power * static_cast<double>(length * segments));
}

// Every other sample of the signal behind the weights 1 4 6 4 1, whose gain is cos^4 of half a turn: low octaves cost as much as the
// next higher one's half.
std::vector<double> halved(const std::vector<double>& signal) {
  std::vector<double> out;
  out.reserve(signal.size() / 2);
  for (size_t n = 2; n + 2 < signal.size(); n += 2)
    out.push_back((signal[n - 2] + 4 * signal[n - 1] + 6 * signal[n] + 4 * signal[n + 1] + signal[n + 2]) / 16);
  return out;
}

// The spectrum of the noise at a turn per sample, as a share of white noise of the same variance.
double noise_shape(const ChannelNoise& noise, double turn) {
  if (!noise.correlation.empty()) {
    double sum = noise.correlation[0];
    for (size_t lag = 1; lag < noise.correlation.size(); ++lag)
      sum += 2.0 * noise.correlation[lag] * std::cos(turn * static_cast<double>(lag));
    return std::max(sum, 0.0);
  }
  return (1.0 - noise.pole * noise.pole) / (1.0 - 2.0 * noise.pole * std::cos(turn) + noise.pole * noise.pole);
}

// Power of a velocity, in codes of the channel and sample periods: with the noise that is sure taken away, and with all that there may be.
struct Power {
  double most = 0, least = 0;
};

// What a channel tells of a velocity's spectrum, octave by octave downwards.
class VelocitySpectrum {
 public:
  VelocitySpectrum(const Record& record, int node, int q, const ChannelNoise& noise) : q_(q), noise_(noise) {
    for (const firmware::RawSample& sample : record) signal_.push_back(sample.code[node][q]);
  }

  size_t length() const { return signal_.size() << halvings_; }  // in samples of the record

  // In lines `first` to `end` of segments of so many samples of the record; no longer ones than before may come later.
  Power at(size_t length, int first, int end) {
    while (length >> halvings_ > kMostSegment) signal_ = halved(signal_), ++halvings_;
    Power sum;
    const double doubt = std::min(noise_.doubt, 1.0), variance = noise_.deviation * noise_.deviation;
    for (int line = first; line < end && (length >> halvings_) <= signal_.size(); ++line) {
      const double turn = 2.0 * M_PI * line / static_cast<double>(length);
      double gain = 1.0;
      for (int h = 0; h < halvings_; ++h) gain *= std::pow(std::cos(std::ldexp(turn, h - 1)), 8);
      const double weight = std::pow(turn, 2 * (kV - q_));
      const double power = line_power(signal_, length >> halvings_, line) / gain;
      const double of_noise = 2.0 / static_cast<double>(length) * variance * noise_shape(noise_, turn);
      sum.most += weight * std::max(power - (1.0 - doubt) * of_noise, 0.0);
      sum.least += weight * std::max(power - (1.0 + doubt) * of_noise, 0.0);
    }
    return sum;
  }

 private:
  static constexpr size_t kMostSegment =
      64;  // eight samples a period at least: what folds down has passed a gain of 1e-3

  int q_, halvings_ = 0;
  const ChannelNoise& noise_;
  std::vector<double> signal_;
};

// Octave o: from rate / 2^o to twice that. Below the lowest one that fits into the record, down to two periods in it.
int octaves_to_slowest(const Record& record, int node, int q, const ChannelNoise& noise, int most) {
  VelocitySpectrum spectrum(record, node, q, noise);
  std::vector<Power> octave;
  constexpr int kTop = 2;  // ends at half the rate
  for (int o = kTop; size_t{kFirstLine} << o <= spectrum.length(); ++o)
    octave.push_back(spectrum.at(size_t{kFirstLine} << o, kFirstLine, 2 * kFirstLine));
  if (octave.empty()) return most;
  const size_t longest = spectrum.length();
  const auto edge_line = static_cast<int>(longest >> (kTop + static_cast<int>(octave.size()) - 1));
  octave.push_back(spectrum.at(longest, kLowestLine, std::max(edge_line, kLowestLine)));
  double all = 0.0, below = 0.0;
  for (const Power& power : octave) all += power.least;
  if (!(all > 0.0)) return 0;
  int answer = kTop + static_cast<int>(octave.size()) - 1;
  for (size_t o = octave.size(); o-- > 0; --answer) {
    below += octave[o].most;
    if (below > kMostBelow * all) break;
  }
  return answer;
}

}  // namespace

int octaves_to_slowest_motion(const CoreConfiguration& configuration, const std::vector<Record>& records,
                              const NodeNoise& noise, int most) {
  int slowest = 0;
  for (int node = 0; node < firmware::kMaxNodes; ++node) {
    const int q = channel_of_velocity(configuration, node);
    if (q < 0) continue;
    for (const Record& record : records)
      slowest = std::max(slowest, octaves_to_slowest(record, node, q, noise[node][q], most));
  }
  return slowest == 0 ? most : std::min(slowest, most);
}

}  // namespace rig_file
