"""How a wrong answer came about: the slips that give it, part by part and call by call; else, what is certain.

    certain     what is certain where none fits
    explanation what an explanation is
    confused    which word a function says for which
    components  a given point with its numbers in other places
    turning     how a point was turned in the plane
    givens      what was given, as it was
    kinds       what is of the wrong kind, plain to see
    habits      what habits of writing give: the first member, a loop that removes
    together    what is said of several parts at once
    edges       edges that were named by their parents
    orders      an order the other way round, or one place off
    slips_in_parts  which slips of a task explain which parts
    after       what another part is, once a slip is known in one
    members     parts of a dict, fields of a message, each by itself
    lists       members of a list, all together
    robots      links of a robot, each by itself
    refusals    errors that were swallowed
    requested   for which moment a buffer was asked
    beside      slips that show in different calls
    apart       slips that show in different words
    stops       errors in some calls, beside what is wrong in others
    changes     arguments that were changed
    explain     how a wrong answer came about: slips, alone and two together

Start with `certain.py`.
"""
