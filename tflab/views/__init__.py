"""Seeing it: pictures that stand still, pictures that move, and the same in words.

    style      sizes, colours, and how a number is printed
    libraries  the widget libraries, or the extra that installs them
    picture    what a view hands back
    rerun      what becomes of it when its cell runs again
    eye        from where we look
    frames     how one draws a frame
    labels     where a name may stand
    typed      a block of numbers, quickly
    bodies     what a robot looks like
    axes       which way is forward
    card       the same, for the pocket
    turns      which way it turns, and in which order
    misread    the same numbers, in a wrong frame
    mount      a turned sensor, and two wrong answers
    dominoes   does this product fit
    readings   what does "from A to B" mean
    sentence   which one is the target
    timeline   what the buffer knew, and when
    journey    what happened to a message on its way
    latency    where was I when I saw it
    rulers     one thing, measured from each frame
    placed     how far off does a map put what was seen
    tracks     one drive, told by several frames
    joints     where does the arm's tip end up
    moments    where is it now, if I saw it then
    work       who was busy, and what had to wait
    joins      who knows what, if they join now
    ages       how far behind, as time goes by
    clocks     which clock does each node live in
    suspects   who is left, and which question would tell the most
    order      in which order was it asked, and when was it clear
    visited    how a visit went, step by step
    owners     who says each edge, from which data, by which switch
    gain       what has been learnt between two tests
    panels/    the same, with sliders
    marks      lines, boxes and words as SVG and PDF
    tree       who is whose child
    climb      which way a question takes through it
    upstream_tree             the same as `view_frames` draws it
    bend       often enough
    toolcase   which tool answers what
    scene/     in three dimensions, inside the page
    rviz_status, rviz, shown  what RViz says of what it cannot show; a small RViz, and the same on paper
    film       a picture for each place of a slider
    mathml, export_widgets, export    pages that live on without a kernel
    report_page    a report in a browser, light or dark

A view receives values and, where it must ask, a function
`ask(target_frame, source_frame, stamp_ns)`; it never holds a buffer or a graph.
It returns what it drew, with the same in words.  Start with `style.py`.
"""
