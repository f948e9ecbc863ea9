// What of a rig's numbers hangs on which of several causes it is.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// A number that a rival of a named cause would take out of its interval is not vouched for; what it would be is told.
void mark_between_rivals(const Task& task, const Choice& choice, Diagnosis& d);

// The same where the rows named one cause and its equals, each fitted by free runs beside the rig as given, fitted.base.
// with_it: fitted with the cause.
void mark_rows_rivals(const Task& task, const Choice& fitted, const State& with_it, Diagnosis& d);

// Numbers of a cause that another may stand in for are not vouched for: with that one there they are none. Where of several causes it is
// not known which has the equals, all may be the one.
void mark_replaceable(Diagnosis& d);

// What mark_between_rivals() does, of every unknown number where a rig has but two things that set its scale, and a rival says that it is the other: they are
// all by one factor.
void mark_scaled(const Task& task, double factor, Diagnosis& d);

}  // namespace diagnosis::runs
