// What a model is worth on data that its fit has not seen.
#pragma once
#include <vector>

#include "../diagnosis.hpp"
#include "../search/search.hpp"
#include "free_run.hpp"

namespace diagnosis {

// Fits base and extended model on the first part of each record (or on all of it where there are hold-out records) and
// simulates both freely on the rest.
class Judge {
 public:
  // `full` are the training records, fused; `early` their first parts, fused; `unseen` the hold-out records, fused.
  Judge(const System& system, const std::vector<FusedRecord>& full, const std::vector<FusedRecord>& early,
        std::vector<FusedRecord> unseen, double early_share);
  // A model's terms, fitted on what may be seen.
  std::vector<ActiveTerm> fitted(const std::vector<ActiveTerm>& model) const;
  HoldoutScore score(const std::vector<ActiveTerm>& fitted_model) const;  // on what the fit has not seen
  // The first fitted model simulates that worse than the second, and by more than chance.
  bool clearly_worse(const std::vector<ActiveTerm>& model, const std::vector<ActiveTerm>& other) const;

 private:
  struct Span {
    const FusedRecord& record;
    Eigen::Index from, to;
  };
  std::vector<Span> spans(const std::vector<FusedRecord>& records, double from_share) const;
  HoldoutScore over(const std::vector<FusedRecord>& records, const std::vector<ActiveTerm>& model,
                    double from_share) const;
  const System& system_;
  const std::vector<FusedRecord>&full_, &early_;
  std::vector<FusedRecord> unseen_;
  double early_share_;
};

double mean(const std::vector<double>& values);

}  // namespace diagnosis
