<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AddPosition</name>
    <message>
        <source>Measure %1° again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add position at %1°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BudgetText</name>
    <message>
        <source>%1 others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>many</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Busy</name>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChangeEffects</name>
    <message>
        <source>Estimate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChangeField</name>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChangeKnown</name>
    <message>
        <source>Change what is known of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChangedFileText</name>
    <message>
        <source>“%1” was written by another program or window since it was last read or saved here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is no session now: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file was changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload takes over what is in the file; undo brings back what is here. Overwrite replaces what is in the file, and that cannot be undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChoiceText</name>
    <message>
        <source>slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DialogsText</name>
    <message>
        <source>Sessions (*.alidade);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discarded changes cannot be brought back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An import that was undone has not been saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session before the import has not been saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has unsaved changes, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo brings it back with all that was typed into it, to be saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo leads back to it with all that was typed into it, to be saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discarded, that cannot be brought back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sessions and reports (*.alidade *.pdf);;Sessions (*.alidade);;Reports with a session in them (*.pdf);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save session as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export acceptance report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print acceptance report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The journal will hold who seals this session and a digest of all that it says.
It can be edited afterwards, as a revision, and every edit is told.

Sealed by:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is open in another window (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is saved in one of the two is not in the other. Before either overwrites the other&apos;s changes, it asks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Alidade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Alidade %1&lt;/h3&gt;&lt;p&gt;A measurement workstation for rotatable arc guideways: sightings in, intersection and verdict out.&lt;/p&gt;&lt;p&gt;Licence: GNU General Public License, version 3 or later. It comes without any warranty.&lt;/p&gt;&lt;p&gt;Built with Qt %2.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>overwrites the cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hands in; on to vertical, then to the next row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same, through all shown columns; back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edits what was typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes back what is half typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>excludes or uses the selected rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leads to the next reading that looks misread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>puts in the reading that was probably meant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clears the selected cells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+I, Ctrl+−</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inserts a row above; deletes the selected rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+X, Ctrl+V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copies, cuts, pastes blocks, also with spreadsheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>imports the clipboard, and asks how it is to be taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Shift+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3415224</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is 341°52′24″ on the number pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys of the table</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DifferenceText</name>
    <message>
        <source>Entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>report number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>laboratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>customer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>authorised by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decision rule agreed by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>device serial number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instrument serial number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instrument certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>traceability of the circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit of angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the horizontal circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the vertical circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the pointing zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nominal radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zeros</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how the distance was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expansion of the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expansion of the radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coverage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference intersection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the tolerance limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical angle relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zero α0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zero β0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zero α0 in face 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zero β0 in face 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zero α0 after the readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zero β0 after the readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zero α0 after the readings in face 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing zero β0 after the readings in face 2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FileLock</name>
    <message>
        <source>process %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Forms</name>
    <message>
        <source>0 (exact)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zenith</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Common</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance &amp;L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>required</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the theodolite&apos;s centre to the plane of the arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance; empty means exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Radius R0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal radius of the arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of R0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the nominal radius. A known radius takes it into the fit, and empty means exact; else R − R0 is a closure with it, and without it none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;adius is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free: each arc has its own. Common: one for both arcs. Known: R0 with its σ takes part as one more observation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vert. c&amp;ircle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the vertical circle reads: zenith angles grow downwards, elevation angles upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exact: tan e = y/√(x²+L²), what a theodolite reads. Planar: tan e = y/L, as in the published method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covera&amp;ge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0.95</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage probability of the expanded uncertainty U, between 0 and 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest acceptable intersection; without it there is no verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the tolerance limits: the intersection Δd, which is the part in the plane of the arc of the distance of its centre from the axis, or that distance as a whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the device was set to, where known; shown beside the result, never part of a fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of ref.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How well the reference is known (1σ). With it the reference is a closure, and may help the diagnosis to tell causes apart; it never enters Δd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unstated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One for all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instr&amp;ument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial no.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pointing zeros</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each: sighted anew in every position. One: sighted once for all, so that an error of it cancels in Δd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ ho&amp;rizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stated standard deviation of one horizontal reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stated standard deviation of one vertical reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of &amp;zeros</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as the circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of one sighting of the pointing zeros α0 and β0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of one slider reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dev&amp;ice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulator measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R0 expands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ppm/K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much R0 grows with each kelvin above 20 °C, for which it is stated: 11.5 for steel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;port no.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unique number of the report, printed on each of its pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Au&amp;thorised by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who answers for the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Laboratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name and address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;ustomer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule a&amp;greed by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>who, and where it is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With whom the decision rule was agreed: accept only where |Δd| + U is within the tolerance, reject only where |Δd| − U is beyond it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration certificate of the instrument, for the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the distance was measured, and its traceability; for the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles traceable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To which standards the circles are traceable, and through whom; for the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;itle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;ate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Day of the measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Temp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature of the device and of the air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of temp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L expands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much L grows with each kelvin above 20 °C, for which it is stated; empty where it is as measured at this temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GapText</name>
    <message>
        <source>a jump of the orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>misread values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise larger than stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vertical angle relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, point %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, round %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, face %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: off by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The positions do not close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gap: within the noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One cause: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of %1 causes that look alike here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A gap of no known cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An unknown cause beside %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An unknown cause beside %1 known ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The model holds %1; without, the residuals are %2 instead of %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without the misread value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without 1 misread value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without %1 misread values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as modelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without model effects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the model: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unseen though a plausible size moves Δd by more than U: %1%2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HelpPage</name>
    <message>
        <source>First measurement in ten steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Entering readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The result and its verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How to read the gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty and reliability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known sizes and effects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report, journal and seal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files and recovery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words and symbols</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Known</name>
    <message>
        <source>an effect without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known size of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MoveRows</name>
    <message>
        <source>Move %1 readings to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NextReadingText</name>
    <message>
        <source>point %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, round %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, face %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, about %2 and %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Proposal</name>
    <message>
        <source>face %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReadingColumn</name>
    <message>
        <source>Use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows without a tick are kept, but are no part of the fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the slider&apos;s place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round of readings; empty means 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Round Column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face of the theodolite, 1 or 2; empty means 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Face Column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of the horizontal circle, degrees minutes seconds; 3415224 is 341°52′24″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>horizontal reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zenith β</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of the vertical circle, degrees minutes seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider coordinate where it was read, degrees minutes seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slider reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Slider Column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vα ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual of the horizontal reading in arcseconds: observed − adjusted, right positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vβ ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual of the vertical reading in arcseconds: observed − adjusted, up positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>note</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReadingsEditor</name>
    <message>
        <source>Add point %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 of point %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1 rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1 readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exclude reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exclude %1 readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use %1 readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste %1 readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RemovePosition</name>
    <message>
        <source>Delete position %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReportPart</name>
    <message>
        <source>Picture of the arcs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of the residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Journal of changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Budget of the uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap between model and readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What these readings would not show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines to sign</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RowChoiceText</name>
    <message>
        <source>round %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>face %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RowEntriesText</name>
    <message>
        <source>face 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rounds side by side</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RowMenuText</name>
    <message>
        <source>and %1 further</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All Rounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Sample</name>
    <message>
        <source>Table I of the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A whole measurement, with a gap: two radii that differ by 2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A clean session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing but noise: what a sound fit looks like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One reading misread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten minutes wrong at one point: named, with what was meant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collimation and trunnion tilt found, and Δd free of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tilted trunnion axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One cause, found with its size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same fault, one face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ambiguous: what leaves the same trace, and what to read next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two causes at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A trunnion tilt and a vertical circle that drifts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A knocked tripod</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A jump after 25 of 36 readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise larger than stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>6″ where 2″ are stated, and nothing else wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A guideway out of shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A gap that is described and not pinned on the nearest effect</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SealSession</name>
    <message>
        <source>Seal the session</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SimulationText</name>
    <message>
        <source> By chance alone an end is uncertain by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: about %1 draws would tell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; it would take more draws than can be asked for here to tell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Agrees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does not agree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few draws to tell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No disagreement, but too few draws to be sure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ends of Δd ± U differ from those simulated by %1 and %2; the tolerance is %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Rely on the simulated interval.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Draws without a result, left out: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checked by simulation (JCGM 101, %1 draws), the fit alone: Δd = %2, u = %3, %4 % from %5 to %6. %7 %8</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>“%1” cannot be imported.

%2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StateNoise</name>
    <message>
        <source>State σ of the circles</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>The %1 failed: %2. Nothing typed is lost; save the session and go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> What is needed to report this could not be written to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> What is needed to report this is in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>entries that are not shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 entry differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 entries differ</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TrialText</name>
    <message>
        <source>A dent of the radius, %1 at s = %2°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A horizontal circle with %2 periods a turn, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An instrument that settles, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A distance that grows by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refraction, %1 · sin 2e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backlash of the horizontal circle, %1 on the way back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A warp of order %2 out of the plane, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Misread: %1, round %2, point %3, face %4, %5 by %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>several causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an effect of no catalogue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no known cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knocked after %1 % of the rows: horizontal %2, vertical %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knocked after the pointing zero at %1: horizontal %2, vertical %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius + A cos %1s + B sin %1s with A = %2 mm, B = %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise %1 times the stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was put in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It shows by %1 σ of the readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; there it looks like %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>or</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>True Δd = %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was %1; the answer was %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Named, faint as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too faint to be expected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is in the group named, and the group is no larger than it must be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was %1, and so was the answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Δd with the causes covers the true one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Δd with the causes misses the true one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>VerdictWords</name>
    <message>
        <source>Accepted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intersection needs an arc at 0° and an arc at 180°; not both are there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No verdict: 1 entry could not be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No verdict: %1 entries could not be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What cannot be used is listed with its place. Correct it or exclude its reading: what is stated here rests on the others alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No tolerance stated, so nothing to decide against.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 as modelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not final: the diagnosis is still to speak.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ZeroText</name>
    <message>
        <source>Mean of %1 sightings: α0 %2 ± %3, β0 %4 ± %5 (1σ)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; moved by %1 and %2 meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; without face 2, which not every position has</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ArcPlot</name>
    <message>
        <source>Good: strokes point every way, O1 and O2 lie within the tolerance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: strokes point every way, O1 and O2 lie close to the axis.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::BenchDisplay</name>
    <message>
        <source>Large Display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading entered last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All is read that was to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd = —</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::BlindTrialDialog</name>
    <message>
        <source>Blind Trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anything, or nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clearly, by 6 to 25 σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>faintly, by 2 to 6 σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same number and choices give the same trial; each draw goes on by one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Truth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;hows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Truth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Draw a trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open the seal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sho&amp;w in the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the session of the trial as a new one, its truth still sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of trials at a stretch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diagnosis of trial %1, plan %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No trial drawn yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A session is simulated by the plan from a truth that nobody sees. The diagnosis knows the readings alone; then you open the seal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrong. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed. The diagnosis has answered: open the seal to see what was put in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dr&amp;aw many, open all:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::BudgetPanel</name>
    <message>
        <source>Budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of Δd, as measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of Δd, fit alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the centres  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What comes from the readings is scaled by their scatter, %1 times the stated noise. Pointing zeros and distance enter as stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parts rest on the stated noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No arc is fitted yet, so there is nothing to account for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1σ: how large each effect may plausibly be; share: of the variance. A: by the scatter of these readings; B: by other knowledge.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size from: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>combined, u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expanded, U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 effective degrees of freedom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k σ with k = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of variance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correlation with R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far a wrong radius takes the centre along, −1 to 1: on half an arc it decides the height</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::CauseList</name>
    <message>
        <source>Probability that it is among the causes, given the catalogue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
and a plausible size of %1 (1σ)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It happened between a pointing zero and the first place after it, or that zero was misread; in which of the positions these readings do not tell. No model of a session holds a jump, so there is none to add: sight both zeros again and read the positions anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It happened before %1. No model of a session holds a jump, so there is none to add: look after the stand, sight the pointing zero anew and read this position again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Or leave out the rows before the jump, if the pointing zero of the next position was not sighted after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Or leave out the rows from there on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Or leave out the rows from there on, if it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Or leave out the rows from there on, if the pointing zero of the next position was sighted after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These readings cannot tell it from %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>or</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take exact vertical angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take planar vertical angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the relation of the vertical angle in the form of the measurement: no effect has to be estimated then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimates %1 along with the arcs; undone by Ctrl+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1 to the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add all %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimates all that look alike here, each within its plausible size: U then covers whichever it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add both to the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add all %1 to the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perhaps %1 right beside it, which would move Δd: read the position again before a row is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exclude the row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves the row out of the fit; what was typed stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exclude the rows before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exclude the rows from there on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves the rows out of the fit; what was typed stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to add to the model: U rests on the scatter of the readings already. If the instrument and the place are no better than this, state the larger σ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State σ = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets σ of the horizontal and the vertical circle in the form of the instrument; σ of the pointing zero follows unless it was typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape of the gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It follows the pattern “%1”, which takes up %2 % of the gap. No effect of the catalogue makes it, so nothing can be added to the model: look at what in the set-up has this shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take out of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 out of the model</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ChangedFileBar</name>
    <message>
        <source>Changed file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what differs, and offers to reload, to save elsewhere or to overwrite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You are asked again before the file is overwritten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was written by another program or window.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ChartFiles</name>
    <message>
        <source>&amp;Copy Picture	Ctrl+C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as &amp;SVG…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as &amp;PNG…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;Numbers as CSV…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ClosureBars</name>
    <message>
        <source>What must agree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; with the causes %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>band: ± U at %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; arrow: beyond %1 U</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a part of the command&apos;s name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::EffectsPanel</name>
    <message>
        <source>Plausible size (1σ) %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remedy: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effects estimated along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What Is Known of It…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type what a certificate or a check says of the effect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no effect of the catalogue; it is kept, but not estimated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A ticked effect is estimated along with the arcs. What that costs is in the budget under “model effects”.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::EntryTable</name>
    <message>
        <source>Nothing was entered: this cell takes no numbers.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::EntryWatch</name>
    <message>
        <source>%1: %2 was read where about %3 was expected. Look again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ExportFlow</name>
    <message>
        <source>Export readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing what is exported…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to export yet.

%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::FileFlow</name>
    <message>
        <source>Import readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the clipboard…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 row of readings imported from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rows of readings imported from %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a pipe or a device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is %2: choose a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening “%1”…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be opened.

%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening the session in “%1”…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session attached to %1; it is in no file of its own yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in %1; Undo brings back what was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking at “%1”…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::FindBar</name>
    <message>
        <source>Find in the readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous (Shift+F3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next (F3)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::FindingsPanel</name>
    <message>
        <source>Problems and findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 missing entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 missing entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before what was changed since: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model and readings disagree, see “Gap”. %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 further entries are missing; those after the ones above are listed when these are made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 further entries cannot be used; those after the ones above are listed when these are mended.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::GapHeadline</name>
    <message>
        <source>No diagnosis</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::GapMap</name>
    <message>
        <source>stays with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radii</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the centres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1st quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2nd quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3rd quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4th quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the gap lies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2: %3 of the gap</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::GapPanel</name>
    <message>
        <source>Gap between model and readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weigh the causes with the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd itself never rests on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far Δd is from the reference then helps to tell the causes apart.
Δd with the causes rests on the readings alone, and so does the report.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it would take to explain Δd − reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: the last bar ends at the broken line of the noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it lies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: no part stands out; one that does is where to look.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What must agree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: every bar ends inside the grey band of ± U.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to measure next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What would go unseen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What may cause the gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical angle relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ln B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Natural logarithm of the Bayes factor against no effect at all: above 0 it explains the readings better, above 5 far better, below 0 worse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the readings it explains, in σ of one reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the diagnosis makes of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look-alike</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No candidates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candidates, each by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No diagnosis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The readings are compared with the model as soon as there are any.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without the effects of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as modelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U holds what it may move Δd by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Averaged over what else may be the case, each as likely as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every effect of the catalogue takes part, as large as these readings and what is plausible leave it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd ± U  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The residuals shrink by %1 %, by %2 % on readings held out of the fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The residuals shrink by %1 %; there are too few readings to hold any out of the fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U holds what the pattern may move Δd by; what causes it is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd with the causes is averaged over all that may be the case, each as likely as it is; the first alone would state a U that is too small.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>would show %1 by %2 σ or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>separates every two of %1 by %2 σ or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; one answer is left with a probability of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No further reading of the usual kinds would tell more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both positions are needed to compare them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the causes in the model they agree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One rigid arc turned about a level axis: they agree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plausible
sizes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaves
σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each by itself, of the effects that these readings do not exclude at that size; the most plausible first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves Δd  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaves  σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No effect of plausible size could move Δd noticeably without leaving a trace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At their plausible size, without a clear trace in these readings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;dd to the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;dd %1 to the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: nothing to add to the model</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::GapWaterfall</name>
    <message>
        <source>The gap before and after each cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the stated noise leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: rms %2″, χ²/f %3, Δd = %4 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>χ²/f</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the stated noise leaves: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::HelpWindow</name>
    <message>
        <source>Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages of the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>← Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward →</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find in this page (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not in this page</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportFiles</name>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>180° from line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files to import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>180° from this line of “%1” on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All at 0°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All at 180°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0°, then 180°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportLayout</name>
    <message>
        <source>Columns of the file:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;osition:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Point:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Round:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Face:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Horizontal:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Vertical:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Slider:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xcluded:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Note:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decimal degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees.minutes seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of plain numbers in columns that name no unit. With degrees.minutes seconds 341.5224 is 341°52′24″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Either</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last of them names the columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unit:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Decimals:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows &amp;before:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below it stands as you took such a file the last time.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportPage</name>
    <message>
        <source>Import readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pointing zeros</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ZERO</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sightings of the point of this name are of the pointing zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Na&amp;me in the files:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The readings as they will stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As they &amp;will stand:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add to the readings of this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace: begin a new session wi&amp;th them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What cannot be used, and remarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout of “%1” and those like it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was imported into this session before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the columns of the horizontal and the vertical circle of “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the unit of the angles of “%1”: it does not say.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the position that “%1” was read at: it does not say.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no readings besides the pointing zeros.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 row of readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rows of readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; 1 entry or line cannot be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 entries or lines cannot be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportPreview</name>
    <message>
        <source>?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zenith β</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation β</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportZeros</name>
    <message>
        <source>Horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Zero at %1:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero at %1:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal pointing zero at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical pointing zero at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type it, or later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the files or the session have it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pointing zero at %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::JobStatus</name>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves it at the fit; the next edit takes all up again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fitting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diagnosing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for misread readings…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::JournalPanel</name>
    <message>
        <source>Journal of changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing that stood was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When (UTC)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Universal time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it was called then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>180°, row 28 (point 28), vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it stood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it became</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>suggestion accepted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operator, as the session had it then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking the journal…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::KnownSizesModel</name>
    <message>
        <source>device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of an effect of the catalogue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the session keeps what is known of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plausible size (1σ), taken where nothing is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is known, in the unit of the default; empty: 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its standard uncertainty, in the unit of the default; empty: the default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate or check: the budget names it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (once more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the standard uncertainty of what is known; until then the default is taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session says more than once what is known of this number: all of it is weighed together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. What is known of it belongs to the %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::KnownSizesPanel</name>
    <message>
        <source>What a certificate or a check says takes the place of the default in the uncertainty as measured.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::KnownSizesTable</name>
    <message>
        <source>Known sizes of effects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste what is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear what is known</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::MainWindow</name>
    <message>
        <source>&amp;Measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I&amp;nstrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Se&amp;ssion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>La&amp;boratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reliability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known Sizes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Journal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing takes “%1” here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something went wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] — Alidade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped: misread readings were not looked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The diagnosis was stopped. The next edit takes it up again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::PaperForm</name>
    <message>
        <source>A4 (210 × 297 mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letter (216 × 279 mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Le&amp;ft margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;op</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;ight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page setup of the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report is printed upright; wide margins print it smaller.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::PlotWidget</name>
    <message>
        <source>Menu of the chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy or save the chart, enlarge it, choose what is drawn (right click)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;In	+</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;Out	−</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;Whole	Home</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::PositionTabs</name>
    <message>
        <source>The session has no position with the axis at %1°.
Δd needs the arc at 0° and at 180°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add position at %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1° missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To its readings with Alt+%1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::PrintPreview</name>
    <message>
        <source>Print preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contents…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page Setup…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole Page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReadingsModel</name>
    <message>
        <source>Type here to add a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks misread: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First entered as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still to be read; until then the row is no part of the fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Excluded: kept, but no part of the fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As typed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No other reading checks this one: its residual says nothing of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standardised residual w = v/(s0 σ √r): %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation β</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReadingsTable</name>
    <message>
        <source>Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of the clipboard that were not pasted: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>The last %n column(s) of the clipboard found no room and were not pasted.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alidade::ui::RecoveryDialog</name>
    <message>
        <source>Unsaved changes were kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alidade ended without saving. Recovered, the changes are back in the window, unsaved; the file stays as it is until you save.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept, unsaved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the changes; File, Recover Unsaved Changes… offers them again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The kept changes of “%1” cannot be brought back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::RecoveryKeeper</name>
    <message>
        <source>Unsaved changes would be lost in a crash: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReliabilityPanel</name>
    <message>
        <source>horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>horizontal zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 per mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 per ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reliability of every reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No fit yet: the readings are listed here once they fix an arc.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the slider&apos;s place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round of readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face of the theodolite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was read; behind all readings, what was entered once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observed − adjusted; right and up positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>w</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standardised residual v/(s0 σ √r): of a sound reading it scatters by 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redundancy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of an error that shows in the reading&apos;s own residual, 0 to 1; 0: nothing checks it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detectable ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimal detectable bias: the smallest error that the search for misread readings finds with 80 % chance, at 1 % risk of naming any sound reading of the session, in the noise s0 σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves Δd by mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What an error of that size, unfound, does to the intersection; of what was entered once, an error of one unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few readings: none is checked well enough by the others to tell that it is misread.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 readings are checked by no other: an error in them would not show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every reading is checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every reading is checked. The dearest unfound error: %1, point %2, %3, up to %4, moves Δd by %5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing checks the pointing zeros and the distance: see the last rows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing checks the distance: see the last row.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReportDialog</name>
    <message>
        <source>Acceptance report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 entry cannot be used. The report will list it and give no verdict.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 entries cannot be used. The report will list them and give no verdict.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session leaves empty what a laboratory would state: %1. The report leaves it out; it is filled in on the forms of the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the report holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always: result, U and verdict, findings, terms, excluded and changed readings, notes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (model and readings disagree)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session file and results, &amp;attached to the PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window opens the session out of the PDF again. All readings are in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logo of the laboratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Without</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.jpg *.jpeg *.bmp *.gif *.webp);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReportFlow</name>
    <message>
        <source>Export acceptance report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print acceptance report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceptance report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Choose another in the dialog of the report, or none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no file: choose a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped: no report was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printing the report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped: the report may be printed in part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The printer “%1” cannot be printed on: choose another, or export a PDF.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report sent to the printer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fitting and diagnosing for the report…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ResidualChart</name>
    <message>
        <source>Residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over the Slider Coordinate &amp;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over &amp;Time, in the Order Read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over the &amp;Elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over the &amp;Azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal &amp;Quantiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Standardised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Arcseconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Slider</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ResidualPlot</name>
    <message>
        <source>row in the order read (time)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elevation e (°), up positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>azimuth a (°), right positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal quantile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slider coordinate s (°): φ at 0°, −φ at 180°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standardised residual w</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residual (″)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No arc fitted yet: no residuals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing of what is chosen to be drawn was read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not drawn: %1 that nothing checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % of normal values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>±1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>±3: beyond it 3 of 1000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>±1σ, stated σ = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>±1σ %1, stated σ = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>±3σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slider: %1″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 circle: %2″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, row %1 read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> at e = %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> at a = %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> at s = %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, standardised w = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, normal quantile %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residuals of %1 readings, at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: the same even band from the first row to the last; no drift, no step between rounds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: the marks follow the line inside the band; one that leaves it at an end may be misread.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: an even band about 0, two of three within ±1, hardly one beyond ±3; no wave, no slope.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: an even band about 0, two of three within ±1σ, hardly one beyond ±3σ; no wave, no slope.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ResultPanel</name>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare with published method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed: y points down for zenith angles, ΔR is the last increment, θ are no tilts. The method takes tan e = y/L, which no theodolite reads; do not accept by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model and readings disagree: &lt;a href=&quot;gap&quot;&gt;%1&lt;/a&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured:
these readings do not determine Δd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured:
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd = %1 mm, U = %2 mm at %3 % coverage.
Every effect of the catalogue takes part, as large as these readings and what is plausible leave it. What each brings is on the page Budget.
%4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before what was changed since: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>180°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|O1 − O2|/2  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redundancy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd = %1 mm, U = %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the fit alone, U at %1 % coverage (k = %2); u = %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Reference %1, difference %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some entries cannot be used. They are marked and listed with the reason.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd needs both arcs: type the pointing zero and at least three readings at 0° and at 180°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the distance L, the nominal radius R0, the pointing zeros and at least three readings of the arc at 0° and at 180°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δx (u)  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of the arc, right positive, with its standard uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δy (u)  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of the arc, up positive, with its standard uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R (u)  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fitted radius with its standard uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual rms  ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square of the residuals of all readings of the arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reduced χ²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About 1 where the readings scatter as stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sightings used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|O1 − O2|/2 (u)  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the distance of the centres in the plane of the arc, with its standard uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δx  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δy  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ΔR  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δθx  rad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δθy  rad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd as printed  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd with y up  mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::Safekeeping</name>
    <message>
        <source>in no file yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which is no longer there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which cannot be read any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which was changed since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; kept on %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes in %1 cannot be read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovered %1; not saved yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::SessionDocument</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::SimulationBox</name>
    <message>
        <source>Draws</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check by simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The more draws, the better known the ends of the interval. With 0 as many are made as it takes to tell whether the propagated uncertainty holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws every reading, pointing zero and length from its distribution and fits anew, each time (JCGM 101)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped, for the session has changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few of the draws gave a result.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does the propagated uncertainty hold? Not checked yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>propagated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: the mean of the draws</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the noise is known by the scatter alone, the draws spread a little more; U has it in k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % from  mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Propagated: Δd − U. Simulated: as many draws lie below as above the other end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to  mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::StartPage</name>
    <message>
        <source>Recent files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alidade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does the centre of a rotatable arc lie on its axis? The readings of a theodolite in, the intersection with its uncertainty and a verdict out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a session or report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import readings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide: ten steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typing begins a session, Esc leads back to it, F1 is help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::SuspectBar</name>
    <message>
        <source>Exclude row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings that look misread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What else may have been meant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the row, but takes it out of the fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next (F7)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leads to the reading in the table; asked again, to the next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for misread readings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use %1 (F8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct point %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::TrialList</name>
    <message>
        <source>Score so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan of readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Truth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was put in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical circle eccentricity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Score</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the diagnosis was right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every trial is listed here as it is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>false alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δd ± U covers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No seal was opened yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>still sealed: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::TwoFacesPanel</name>
    <message>
        <source>Two-face table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the slider&apos;s place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round of readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above the pointing zero, mean of both faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2c ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α1 − (α2 ± 180°): twice collimation and trunnion tilt, c/cos e + i·tan e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off its course ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2c as read minus that of the fitted collimation and trunnion tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Index ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the vertical circle reads too much in both faces: half of β1 + β2 over the full sum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collimation c</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trunnion tilt i</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical index j</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From both faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With standard uncertainty; signs of face 1. A trunnion tilt needs three visits at different elevations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scatter against the stated σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About × 1 where the differences of the faces scatter as stated</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::WindowActions</name>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import Readings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import from Clip&amp;board…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reco&amp;ver Unsaved Changes…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no unsaved changes to recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rever&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sea&amp;l…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export Acceptance Report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print Previe&amp;w…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page Set&amp;up…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Readings (CSV)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;siduals (CSV)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;esult (JSON)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gap (JSON)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Budget (CSV)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget These</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste as Readings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find Previous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Insert Reading Above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+-</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xclude or Use	Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;lear Cells	Del</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exclude or use the selected readings (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next Misread Reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use Proposed Readin&amp;g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Ro&amp;ws</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Way Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Way Back in Other &amp;Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another &amp;Round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To Next Entr&amp;y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings at %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure %1° Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Position at %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete Position %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Readings to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A column that the session uses is always shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tone for Unexpected Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;ystem Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;ngles in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees, &amp;Minutes, Seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Decimal Degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Enlarge Lower Pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enlarge over the picture, or back (Ctrl+0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enlarge lower pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;ools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Blind Trial…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;First Measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys of the Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start Page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Alidade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Large D&amp;isplay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Langua&amp;ge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes when Alidade is started again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;Desktop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>alidade::ui::ZeroEntries</name>
    <message>
        <source>required</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pointing zero, horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal circle reading of the direction perpendicular to the plane of the arc, in face 1 before the readings of this position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;α0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pointing zero, vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical circle reading of the direction perpendicular to the plane of the arc, in face 1 before the readings of this position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;β0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the axis in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation of the axis: 0 or 180 degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further sightings of the pointing zero: in face 2, and after the readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further sightings of the pointing zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in face 2 before the readings of this position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in face 1 after the readings of this position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After, face 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in face 2 after the readings of this position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pointing zero, horizontal, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal circle reading of the pointing zero %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pointing zero, vertical, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical circle reading of the pointing zero %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
