// What noise alone puts into the sums of a probe.
//
// A filter carries a sample's noise into its neighbours, so a force made from the neighbours is not independent of the
// sample's own residual. For Gaussian noise Stein's lemma gives what that adds, whatever the force law phi(u, w):
//   mean of phi(u, w) times noise of y  =  mean of dphi/du * cov(u, y)  +  mean of dphi/dw * cov(w, y)
// The means of the slopes are summed beside the probe's products; the covariances follow from the filters and the channels'
// noise (CoreConfiguration::probe_noise). Nothing is taken out where the signals are as measured: white noise of a sample is
// not in its neighbours.
#pragma once
#include "firmware/warrant/motion/block_motion.hpp"
#include "firmware/warrant/probes/probe.hpp"

namespace firmware {

class SharedNoise {
 public:
  void configure(const CoreConfiguration& configuration, const KnownForce& known) {
    configuration_ = &configuration;
    known_ = &known;
  }
  enum class Of { kWhole, kDoubtful };  // the covariance, or the part of it that is in doubt
  // Covariance of the noise in the probe's first or second quantity with that of a column of the equations, or with that of
  // the known part of a DOF's equation; SI units.
  Scaled with_column(const Place& place, Form form, int quantity, int column, Of of) const;
  Scaled with_known(const Place& place, Form form, int quantity, int dof, Of of) const;

 private:
  Scaled of_node(int node, ProbeWeight weight, Quantity quantity, Of of) const;
  Scaled of_ends(const Place& place, ProbeWeight weight, Quantity quantity, int node_a, int node_b, Of of) const;

  const CoreConfiguration* configuration_ = nullptr;
  const KnownForce* known_ = nullptr;
};

}  // namespace firmware
