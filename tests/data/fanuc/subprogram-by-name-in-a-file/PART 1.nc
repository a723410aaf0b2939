%
<PART 1>
X2.
M99
%
